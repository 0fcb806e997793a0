// SPDX-License-Identifier: BSD-3-Clause
/// Traversal of the hierarchy by a packet of neighbouring camera rays.
///
/// A node is tested once for the whole packet, by where its boxes lie in the picture and how near
/// they are, instead of by its rays; a sphere is then tested against the rays that its footprint
/// covers. Sources: Wald, Slusallek, Benthin and Wagner, "Interactive Rendering with Coherent Ray
/// Tracing" (2001), for packets; Reshetov, Soupikov and Hurley, "Multi-Level Ray Tracing Algorithm"
/// (2005), for frusta that visit the tree in their place.
#ifndef TraceBvhBlock_h
#define TraceBvhBlock_h

#include "base/SphereArrays.h"
#include "trace/BlockProjection.h"
#include "trace/BvhStack.h"

namespace spherepacking
{
inline namespace SPHEREPACKING_ISA
{
class BlockTracer
{
public:
  BlockTracer(const Bvh& bvh, const SphereArrays& spheres, const CameraRays& rays,
    const CameraProjection& camera, RayBlock& block)
    : Hierarchy(bvh)
    , Spheres(spheres)
    , Block(block)
    , Projection(rays, camera, block, bvh)
  {
  }

  void Run()
  {
    if (this->Hierarchy.Nodes.empty())
    {
      return;
    }
    this->MaxDepth.Update(this->Block, AllCells, this->Projection.DepthScale());
    this->Stack.Entries[this->Stack.Number++] = { 0, -3e38f, CellDepths::Whole };
    while (this->Stack.Number > 0)
    {
      const BvhStack::Entry entry = this->Stack.Entries[--this->Stack.Number];
      if (entry.Depth > this->MaxDepth[entry.Rectangle])
      {
        continue;
      }
      if (BvhChild::IsLeaf(entry.Child))
      {
        this->QueueLeaf(entry);
      }
      else
      {
        this->PushChildren(this->Hierarchy.Nodes[entry.Child], this->MaxDepth[entry.Rectangle]);
      }
    }
    while (this->Queued > 0)
    {
      this->IntersectFirst();
    }
  }

private:
  static constexpr unsigned AllCells = 0xffff;
  static constexpr int QueueLength = 3;

  // Leaves wait until two more have come, by when they have arrived from memory.
  void QueueLeaf(const BvhStack::Entry& leaf)
  {
    this->Hierarchy.Prefetch(leaf.Child);
    this->Queue[this->Queued++] = leaf;
    if (this->Queued == QueueLength)
    {
      this->IntersectFirst();
    }
  }

  void IntersectFirst()
  {
    const BvhStack::Entry first = this->Queue[0];
    std::copy(this->Queue + 1, this->Queue + this->Queued, this->Queue);
    --this->Queued;
    if (first.Depth <= this->MaxDepth[first.Rectangle])
    {
      this->IntersectLeaf(BvhChild::Index(first.Child), this->MaxDepth[first.Rectangle]);
    }
  }

  // Pushes the children of a node that a ray may hit before `maxDepth`.
  void PushChildren(const BvhNode& node, float maxDepth)
  {
    Footprints footprints;
    const int bottom = this->Stack.Number;
    for (unsigned hit = this->Projection.Test(node, maxDepth, footprints); hit != 0; hit &= hit - 1)
    {
      const int i = __builtin_ctz(hit);
      const unsigned rectangle = footprints.Rectangle[i];
      if (footprints.Nearest[i] <= this->MaxDepth[rectangle])
      {
        if (!BvhChild::IsLeaf(node.Children[i]))
        {
          this->Hierarchy.Prefetch(node.Children[i]);
        }
        this->Stack.Insert(bottom, { node.Children[i], footprints.Nearest[i], rectangle });
      }
    }
  }

  void IntersectLeaf(std::uint32_t index, float maxDepth)
  {
    const BvhLeaf& leaf = this->Hierarchy.Leaves[index];
    Footprints footprints;
    unsigned hit = this->Projection.Test(this->Hierarchy, leaf, maxDepth, footprints);
    const bool exact = this->Hierarchy.Exact;
    for (unsigned bits = exact ? 0u : hit; bits != 0; bits &= bits - 1)
    {
      this->Spheres.Prefetch(leaf.Ids[__builtin_ctz(bits)]);
    }
    unsigned changed = 0;
    for (; hit != 0; hit &= hit - 1)
    {
      const int i = __builtin_ctz(hit);
      if (footprints.Nearest[i] > this->MaxDepth[footprints.Rectangle[i]])
      {
        continue;
      }
      const Sphere sphere = exact ? leaf.At(i) : this->Spheres[leaf.Ids[i]];
      const std::uint32_t slot = index * BvhLeaf::Width + static_cast<std::uint32_t>(i);
      const RayRectangle rays = footprints.RaysOf(i);
      const double nearest = this->Projection.Depth(footprints.Nearest[i]);
      if (this->Block.Offer(sphere, MakeKey(leaf.Ids[i], slot), rays, nearest))
      {
        changed |= rays.Cells();
      }
    }
    if (changed != 0)
    {
      this->MaxDepth.Update(this->Block, changed, this->Projection.DepthScale());
    }
  }

  const Bvh& Hierarchy;
  const SphereArrays& Spheres;
  RayBlock& Block;
  const BlockProjection Projection;
  BvhStack Stack;
  BvhStack::Entry Queue[QueueLength];
  int Queued = 0;
  CellDepths MaxDepth;
};

inline void TraceBlock(const Bvh& bvh, const SphereArrays& spheres, const CameraRays& rays,
  const CameraProjection& camera, RayBlock& block)
{
  BlockTracer(bvh, spheres, rays, camera, block).Run();
}
}
}

#endif
