// SPDX-License-Identifier: BSD-3-Clause
#ifndef BvhStack_h
#define BvhStack_h

#include <cstdint>

namespace spherepacking
{
inline namespace SPHEREPACKING_ISA
{
/// The children that a traversal has still to visit, the nearest on top.
struct BvhStack
{
  // Eight children replace their node, on no more than 51 levels.
  static constexpr int Maximum = 512;

  struct Entry
  {
    std::uint32_t Child;
    float Depth;        ///< where the child begins
    unsigned Rectangle; ///< of a packet's cells that may see it, see CellDepths
  };
  Entry Entries[Maximum];
  int Number = 0;

  /// Puts an entry among those above `bottom`, the nearest of which is on top.
  void Insert(int bottom, const Entry& entry)
  {
    int at = this->Number++;
    for (; at > bottom && this->Entries[at - 1].Depth < entry.Depth; --at)
    {
      this->Entries[at] = this->Entries[at - 1];
    }
    this->Entries[at] = entry;
  }
};
}
}

#endif
