// SPDX-License-Identifier: BSD-3-Clause
/// First hits through the hierarchy: of a block of neighbouring rays, and of a single one.
#ifndef TraceBvhBlock_h
#define TraceBvhBlock_h

#include "trace/BlockProjection.h"
#include "base/SphereArrays.h"

namespace spherepacking
{
inline namespace SPHEREPACKING_ISA
{
/// Children that wait for their turn, the nearest on top.
struct BvhStack
{
  // Eight children replace their node, on no more than 51 levels.
  static constexpr int Maximum = 512;

  struct Entry
  {
    std::uint32_t Child;
    float Depth;
    unsigned Rectangle; ///< of CellDepths, that may see it
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

/// A block on its way through the hierarchy.
class BlockTracer
{
public:
  BlockTracer(const Bvh& bvh, const SphereArrays& spheres, const CameraRays& rays,
    const Screen& screen, RayBlock& block)
    : Hierarchy(bvh)
    , Spheres(spheres)
    , Block(block)
    , Places(rays, screen, block, bvh)
  {
  }

  void Run()
  {
    if (this->Hierarchy.Nodes.empty())
    {
      return;
    }
    this->Last.Update(this->Block, AllCells, this->Places.DepthScale());
    this->Stack.Entries[this->Stack.Number++] = { 0, -3e38f, CellDepths::Whole };
    while (this->Stack.Number > 0)
    {
      const BvhStack::Entry entry = this->Stack.Entries[--this->Stack.Number];
      if (entry.Depth > this->Last[entry.Rectangle])
      {
        continue;
      }
      if (BvhChild::IsLeaf(entry.Child))
      {
        this->Wait(entry);
      }
      else
      {
        this->Push(this->Hierarchy.Nodes[entry.Child], this->Last[entry.Rectangle]);
      }
    }
    while (this->Waiting > 0)
    {
      this->OfferFirst();
    }
  }

private:
  static constexpr unsigned AllCells = 0xffff;
  static constexpr int QueueLength = 3;

  // Leaves wait until two more have come, by when they have arrived from memory.
  void Wait(const BvhStack::Entry& leaf)
  {
    this->Hierarchy.Prefetch(leaf.Child);
    this->Queue[this->Waiting++] = leaf;
    if (this->Waiting == QueueLength)
    {
      this->OfferFirst();
    }
  }

  void OfferFirst()
  {
    const BvhStack::Entry first = this->Queue[0];
    std::copy(this->Queue + 1, this->Queue + this->Waiting, this->Queue);
    --this->Waiting;
    if (first.Depth <= this->Last[first.Rectangle])
    {
      this->Offer(BvhChild::Index(first.Child), this->Last[first.Rectangle]);
    }
  }

  // Puts the children of a node that may be seen before `last` on the stack.
  void Push(const BvhNode& node, float last)
  {
    BlockParts parts;
    const int bottom = this->Stack.Number;
    for (unsigned seen = this->Places.Test(node, last, parts); seen != 0; seen &= seen - 1)
    {
      const int i = __builtin_ctz(seen);
      const unsigned rectangle = parts.Rectangle[i];
      if (parts.Nearest[i] <= this->Last[rectangle])
      {
        if (!BvhChild::IsLeaf(node.Children[i]))
        {
          this->Hierarchy.Prefetch(node.Children[i]);
        }
        this->Stack.Insert(bottom, { node.Children[i], parts.Nearest[i], rectangle });
      }
    }
  }

  void Offer(std::uint32_t index, float last)
  {
    const BvhLeaf& leaf = this->Hierarchy.Leaves[index];
    BlockParts parts;
    unsigned seen = this->Places.Test(this->Hierarchy, leaf, last, parts);
    const bool exact = this->Hierarchy.Exact;
    for (unsigned bits = exact ? 0u : seen; bits != 0; bits &= bits - 1)
    {
      this->Spheres.Prefetch(leaf.Ids[__builtin_ctz(bits)]);
    }
    unsigned changed = 0;
    for (; seen != 0; seen &= seen - 1)
    {
      const int i = __builtin_ctz(seen);
      if (parts.Nearest[i] > this->Last[parts.Rectangle[i]])
      {
        continue;
      }
      const Sphere sphere = exact ? leaf.At(i) : this->Spheres[leaf.Ids[i]];
      const std::uint32_t place = index * BvhLeaf::Width + static_cast<std::uint32_t>(i);
      const BlockPart part = parts.Of(i);
      if (this->Block.Offer(
            sphere, MakeKey(leaf.Ids[i], place), part, this->Places.Depth(parts.Nearest[i])))
      {
        changed |= part.Cells();
      }
    }
    if (changed != 0)
    {
      this->Last.Update(this->Block, changed, this->Places.DepthScale());
    }
  }

  const Bvh& Hierarchy;
  const SphereArrays& Spheres;
  RayBlock& Block;
  const BlockScreen Places;
  BvhStack Stack;
  BvhStack::Entry Queue[QueueLength];
  int Waiting = 0;
  CellDepths Last;
};

inline void TraceBlock(const Bvh& bvh, const SphereArrays& spheres, const CameraRays& rays,
  const Screen& screen, RayBlock& block)
{
  BlockTracer(bvh, spheres, rays, screen, block).Run();
}
}
}

#endif
