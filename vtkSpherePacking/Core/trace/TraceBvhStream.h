// SPDX-License-Identifier: BSD-3-Clause
/// First hits of many rays that start near each other and go apart.
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
  std::int64_t Left[Maximum]; ///< which sphere a ray leaves
  Hit Hits[Maximum];

  /// Finds the first hit of each ray, or some hit.
  template <bool AnyT>
  void Trace(const Scene& scene)
  {
    if (scene.Hierarchy)
    {
      this->Trace<AnyT>(*scene.Hierarchy, scene.Spheres);
      return;
    }
    for (int i = 0; i < this->Count; ++i)
    {
      this->Hits[i] = FirstHitImpl(scene, this->Rays[i], OuterSurface<AnyT>{ this->Left[i] });
    }
  }

private:
  template <bool AnyT>
  void Trace(const Bvh& bvh, const SphereArrays& spheres)
  {
    this->Hierarchy = &bvh;
    this->Spheres = &spheres;
    Number lists[8][Maximum];
    int counts[8] = {};
    for (int i = 0; i < this->Count; ++i)
    {
      this->Hits[i] = Hit();
      this->Lines[i] = BvhRay(bvh, this->Rays[i]);
      this->Last[i] = this->Lines[i].Scaled(this->Hits[i].T);
      this->InverseSquares[i] = InverseSquare(this->Rays[i]);
      const unsigned octant = this->Lines[i].Octant();
      lists[octant][counts[octant]++] = static_cast<Number>(i);
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
        this->Visit<AnyT>(bvh.Nodes[0], lists[octant], counts[octant], this->Arena);
      }
    }
  }

  // Of a ray.
  using Number = std::uint16_t;

  // A list on each of no more than 51 levels.
  static constexpr int ArenaSize = 51 * Maximum;

  template <bool AnyT>
  void Visit(const BvhNode& node, const Number* list, int count, Number* arena)
  {
    std::uint8_t masks[Maximum];
    unsigned seen = 0;
    Float8 enter;
    const BvhPlanes planes(node, this->Up);
    Float8 key = Float8{};
    for (int axis = 0; axis < 3; ++axis)
    {
      const Float8 in = Load<Float8>(planes.In[axis]);
      key += this->Up[axis] ? in : -in;
    }
    for (int k = 0; k < count; ++k)
    {
      const unsigned mask = this->Lines[list[k]].Test(planes, this->Last[list[k]], enter);
      masks[k] = static_cast<std::uint8_t>(mask);
      seen |= mask;
    }
    if (seen == 0)
    {
      return;
    }
    float keys[BvhNode::Width];
    Store(key, keys);
    int order[BvhNode::Width];
    int children = 0;
    for (; seen != 0; seen &= seen - 1)
    {
      const int i = __builtin_ctz(seen);
      int at = children++;
      for (; at > 0 && keys[order[at - 1]] > keys[i]; --at)
      {
        order[at] = order[at - 1];
      }
      order[at] = i;
    }
    for (int c = 0; c < children; ++c)
    {
      const int i = order[c];
      int number = 0;
      for (int k = 0; k < count; ++k)
      {
        arena[number] = list[k];
        number += (masks[k] >> i) & 1;
      }
      const std::uint32_t child = node.Children[i];
      if (number == 1)
      {
        const int only = arena[0];
        HitBelow(*this->Hierarchy, *this->Spheres, this->Rays[only], this->Lines[only],
          this->InverseSquares[only], OuterSurface<AnyT>{ this->Left[only] }, child,
          this->Hits[only], this->Last[only]);
      }
      else if (BvhChild::IsLeaf(child))
      {
        this->Offer<AnyT>(this->Hierarchy->Leaves[BvhChild::Index(child)], arena, number);
      }
      else
      {
        this->Visit<AnyT>(this->Hierarchy->Nodes[child], arena, number, arena + number);
      }
    }
  }

  template <bool AnyT>
  void Offer(const BvhLeaf& leaf, const Number* list, int count)
  {
    for (int k = 0; k < count; ++k)
    {
      const int i = list[k];
      OfferLeaf(*this->Hierarchy, *this->Spheres, this->Rays[i], this->Lines[i],
        this->InverseSquares[i], OuterSurface<AnyT>{ this->Left[i] }, leaf, this->Hits[i],
        this->Last[i]);
    }
  }

  const Bvh* Hierarchy;
  const SphereArrays* Spheres;
  bool Up[3];
  BvhRay Lines[Maximum];
  float Last[Maximum];
  double InverseSquares[Maximum];
  Number Arena[ArenaSize];
};
}
}

#endif
