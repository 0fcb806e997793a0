// SPDX-License-Identifier: BSD-3-Clause
/// First hits through the hierarchy: of a block of neighbouring rays, and of a single one.
#ifndef TraceBvh_h
#define TraceBvh_h

#include "kernels/BlockScreen.h"
#include "kernels/Frustum.h"
#include "kernels/SphereArrays.h"

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
  };
  Entry Entries[Maximum];
  int Number = 0;

  /// Pushes the children whose bit is set, the nearest last.
  void Push(const BvhNode& node, unsigned bits, const float (&depth)[BvhNode::Width])
  {
    const int bottom = this->Number;
    for (; bits != 0; bits &= bits - 1)
    {
      const int i = __builtin_ctz(bits);
      int at = this->Number++;
      for (; at > bottom && this->Entries[at - 1].Depth < depth[i]; --at)
      {
        this->Entries[at] = this->Entries[at - 1];
      }
      this->Entries[at] = { node.Children[i], depth[i] };
    }
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
    , View(rays, screen, block, bvh)
    , Places(rays, screen, block, bvh)
  {
  }

  void Run()
  {
    if (this->Hierarchy.Nodes.empty())
    {
      return;
    }
    this->SetLast();
    BvhStack stack;
    stack.Entries[stack.Number++] = { 0, -3e38f };
    while (stack.Number > 0)
    {
      const BvhStack::Entry entry = stack.Entries[--stack.Number];
      if (entry.Depth > this->ScaledLast)
      {
        continue;
      }
      if (BvhChild::IsLeaf(entry.Child))
      {
        this->Offer(BvhChild::Index(entry.Child));
        continue;
      }
      const BvhNode& node = this->Hierarchy.Nodes[entry.Child];
      float depth[BvhNode::Width];
      const unsigned seen = this->View.Test(node, depth, this->ScaledLast);
      for (unsigned bits = seen; bits != 0; bits &= bits - 1)
      {
        this->Hierarchy.Prefetch(node.Children[__builtin_ctz(bits)]);
      }
      stack.Push(node, seen, depth);
    }
  }

private:
  void SetLast()
  {
    this->Last = this->Block.LastDepth();
    this->ScaledLast = this->View.ScaledDepth(this->Last);
  }

  void Offer(std::uint32_t index)
  {
    const BvhLeaf& leaf = this->Hierarchy.Leaves[index];
    LeafParts parts;
    unsigned seen = this->Places.Test(this->Hierarchy, leaf, this->ScaledLast, parts);
    const bool exact = this->Hierarchy.Exact;
    for (unsigned bits = exact ? 0u : seen; bits != 0; bits &= bits - 1)
    {
      this->Spheres.Prefetch(leaf.Ids[__builtin_ctz(bits)]);
    }
    const bool offered = seen != 0;
    for (; seen != 0; seen &= seen - 1)
    {
      const int i = __builtin_ctz(seen);
      const Sphere sphere = exact ? leaf.At(i) : this->Spheres[leaf.Ids[i]];
      const std::uint32_t place = index * BvhLeaf::Width + static_cast<std::uint32_t>(i);
      this->Block.Offer(sphere, MakeKey(leaf.Ids[i], place), parts.Of(i),
        this->View.Depth(parts.Nearest[i]));
    }
    if (offered)
    {
      this->SetLast();
    }
  }

  const Bvh& Hierarchy;
  const SphereArrays& Spheres;
  RayBlock& Block;
  const Frustum View;
  const BlockScreen Places;
  double Last;
  float ScaledLast;
};

inline void TraceBlock(const Bvh& bvh, const SphereArrays& spheres, const CameraRays& rays,
  const Screen& screen, RayBlock& block)
{
  BlockTracer(bvh, spheres, rays, screen, block).Run();
}
}
}

#endif
