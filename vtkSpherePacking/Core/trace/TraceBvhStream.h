// SPDX-License-Identifier: BSD-3-Clause
/// Traversal of the hierarchy by a stream of secondary rays that start near each other and go
/// apart.
///
/// Rays that go the same way along each axis visit the hierarchy together: a node's boxes are
/// tested against all rays that reach it, then each child is visited with those that may hit it.
/// Source: Barringer and Akenine-Moller, "Dynamic Ray Stream Traversal" (2014).
#ifndef TraceBvhStream_h
#define TraceBvhStream_h

#include "trace/FirstHit.h"

namespace spherepacking
{
inline namespace SPHEREPACKING_ISA
{
class RayStream
{
public:
  static constexpr int Maximum = 1024;

  int Count = 0;
  Ray Rays[Maximum];
  std::int64_t OriginSphere[Maximum]; ///< id of the sphere that a ray leaves
  Hit Hits[Maximum];

  /// Finds the closest hit of each ray, or any hit, through the structure of the scene.
  template <bool AnyHit>
  void Trace(const Scene& scene)
  {
    if (scene.Hierarchy)
    {
      this->Trace<AnyHit>(*scene.Hierarchy, scene.Spheres);
      return;
    }
    for (int i = 0; i < this->Count; ++i)
    {
      this->Hits[i] =
        FirstHitImpl(scene, this->Rays[i], SecondaryRay<AnyHit>{ this->OriginSphere[i] });
    }
  }

private:
  using RayIndex = std::uint16_t;

  // Indices of the rays that reach a node, on each of no more than 51 levels.
  static constexpr int ArenaSize = 51 * Maximum;

  template <bool AnyHit>
  void Trace(const Bvh& bvh, const SphereArrays& spheres)
  {
    this->Hierarchy = &bvh;
    this->Spheres = &spheres;
    RayIndex lists[8][Maximum];
    int counts[8] = {};
    for (int i = 0; i < this->Count; ++i)
    {
      this->Hits[i] = Hit();
      this->Lines[i] = BvhRay(bvh, this->Rays[i]);
      this->TMax[i] = this->Lines[i].Scaled(this->Hits[i].T);
      this->InverseSquares[i] = InverseSquare(this->Rays[i]);
      const unsigned octant = this->Lines[i].Octant();
      lists[octant][counts[octant]++] = static_cast<RayIndex>(i);
    }
    if (bvh.Nodes.empty())
    {
      return;
    }
    for (int octant = 0; octant < 8; ++octant)
    {
      if (counts[octant] > 0)
      {
        for (int axis = 0; axis < 3; ++axis)
        {
          this->Up[axis] = (octant >> axis) & 1;
        }
        this->Visit<AnyHit>(bvh.Nodes[0], lists[octant], counts[octant], this->Arena);
      }
    }
  }

  // Tests the boxes of a node against the rays of a list and visits the children that any of them
  // may hit, in the order in which rays of this octant enter them.
  template <bool AnyHit>
  void Visit(const BvhNode& node, const RayIndex* list, int count, RayIndex* arena)
  {
    std::uint8_t masks[Maximum]; // of each ray, which children it may hit
    const BvhSlabs slabs(node, this->Up);
    unsigned hit = 0;
    Float8 enter;
    for (int k = 0; k < count; ++k)
    {
      const unsigned mask = this->Lines[list[k]].Test(slabs, this->TMax[list[k]], enter);
      masks[k] = static_cast<std::uint8_t>(mask);
      hit |= mask;
    }
    int order[BvhNode::Width];
    const int children = this->SortChildren(slabs, hit, order);
    for (int c = 0; c < children; ++c)
    {
      const int i = order[c];
      int number = 0;
      for (int k = 0; k < count; ++k)
      {
        arena[number] = list[k];
        number += (masks[k] >> i) & 1;
      }
      this->VisitChild<AnyHit>(node.Children[i], arena, number);
    }
  }

  // The children of a bit mask by the distance of the planes through which rays enter them.
  int SortChildren(const BvhSlabs& slabs, unsigned mask, int (&order)[BvhNode::Width]) const
  {
    Float8 key = Float8{};
    for (int axis = 0; axis < 3; ++axis)
    {
      const Float8 in = Load<Float8>(slabs.In[axis]);
      key += this->Up[axis] ? in : -in;
    }
    float keys[BvhNode::Width];
    Store(key, keys);
    int children = 0;
    for (; mask != 0; mask &= mask - 1)
    {
      const int i = __builtin_ctz(mask);
      int at = children++;
      for (; at > 0 && keys[order[at - 1]] > keys[i]; --at)
      {
        order[at] = order[at - 1];
      }
      order[at] = i;
    }
    return children;
  }

  // A ray that is alone goes on by itself.
  template <bool AnyHit>
  void VisitChild(std::uint32_t child, RayIndex* list, int count)
  {
    if (count == 1)
    {
      const int i = list[0];
      TraverseFrom(*this->Hierarchy, *this->Spheres, this->Rays[i], this->Lines[i],
        this->InverseSquares[i], SecondaryRay<AnyHit>{ this->OriginSphere[i] }, child,
        this->Hits[i], this->TMax[i]);
    }
    else if (BvhChild::IsLeaf(child))
    {
      const BvhLeaf& leaf = this->Hierarchy->Leaves[BvhChild::Index(child)];
      for (int k = 0; k < count; ++k)
      {
        const int i = list[k];
        IntersectLeaf(*this->Hierarchy, *this->Spheres, this->Rays[i], this->Lines[i],
          this->InverseSquares[i], SecondaryRay<AnyHit>{ this->OriginSphere[i] }, leaf,
          this->Hits[i], this->TMax[i]);
      }
    }
    else
    {
      this->Visit<AnyHit>(
        this->Hierarchy->Nodes[BvhChild::Index(child)], list, count, list + count);
    }
  }

  const Bvh* Hierarchy;
  const SphereArrays* Spheres;
  bool Up[3]; // along which axes the rays of the present octant go up
  BvhRay Lines[Maximum];
  float TMax[Maximum];
  double InverseSquares[Maximum];
  RayIndex Arena[ArenaSize];
};
}
}

#endif
