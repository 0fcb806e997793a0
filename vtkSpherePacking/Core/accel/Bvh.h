// SPDX-License-Identifier: BSD-3-Clause
/// The bounding volume hierarchy that rays traverse: eight children per node and up to eight
/// spheres per leaf (a wide BVH, as of Wald, Benthin and Boulos, "Getting Rid of Packets", 2008).
///
/// Boxes and spheres are single precision in coordinates that take the scene's box to [-1, 1],
/// where rounding is the same whatever the scene's unit and position. They are conservative,
/// rounding included: they say what a ray cannot hit, and the packing's own numbers say what it
/// does.
#ifndef Bvh_h
#define Bvh_h

#include "base/HugeArray.h"
#include "base/Sphere.h"

#include <cstddef>
#include <cstdint>

namespace spherepacking
{
struct alignas(32) BvhNode
{
  static constexpr int Width = 8;

  // Axis by axis. The box of an empty slot is inside out.
  float Low[3][Width];
  float High[3][Width];
  std::uint32_t Children[Width];
};

struct alignas(32) BvhLeaf
{
  static constexpr int Width = 8;

  float Center[3][Width];
  float Radius[Width]; ///< far below 0 where there is no sphere
  std::int32_t Ids[Width];

  Sphere At(int i) const
  {
    return { this->Center[0][i], this->Center[1][i], this->Center[2][i], this->Radius[i] };
  }
};

/// A reference to a child: the index of a node or, with the highest bit set, of a leaf. The root is
/// no child, so 0 stands for an empty slot.
struct BvhChild
{
  static constexpr std::uint32_t LeafBit = 1u << 31;

  static bool IsLeaf(std::uint32_t child) { return (child & LeafBit) != 0; }
  static std::uint32_t Index(std::uint32_t child) { return child & ~LeafBit; }
};

struct Bvh
{
  HugeArray<BvhNode> Nodes; ///< the root first; empty without spheres
  HugeArray<BvhLeaf> Leaves;
  double Center[3]; ///< about the middle of the scene's box
  double Scale;     ///< a point p has the coordinates (p - Center) Scale; a power of two

  /// Whether leaves hold the packing's own numbers. Their coordinates are (p - LeafCenter)
  /// LeafScale in either case.
  bool Exact;
  float LeafCenter[3];
  float LeafScale;

  /// Prefetches a child that will be visited.
  void Prefetch(std::uint32_t child) const
  {
    const bool leaf = BvhChild::IsLeaf(child);
    const std::uint32_t index = BvhChild::Index(child);
    const char* begin = leaf ? reinterpret_cast<const char*>(&this->Leaves[index])
                             : reinterpret_cast<const char*>(&this->Nodes[index]);
    const std::size_t length = leaf ? sizeof(BvhLeaf) : sizeof(BvhNode);
    constexpr std::size_t line = 64;
    for (std::size_t at = 0; at < length; at += line)
    {
      __builtin_prefetch(begin + at);
    }
  }

  /// The sphere in a slot, which is eight times the leaf plus the lane in it, if `Exact`.
  Sphere At(std::uint32_t slot) const
  {
    return this->Leaves[slot / BvhLeaf::Width].At(static_cast<int>(slot % BvhLeaf::Width));
  }

  std::size_t Bytes() const
  {
    return this->Nodes.size() * sizeof(BvhNode) + this->Leaves.size() * sizeof(BvhLeaf);
  }
};
}

#endif
