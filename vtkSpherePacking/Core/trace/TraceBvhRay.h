// SPDX-License-Identifier: BSD-3-Clause
/// Traversal of the hierarchy by a single ray.
#ifndef TraceBvhRay_h
#define TraceBvhRay_h

#include "base/SphereArrays.h"
#include "trace/BvhRay.h"
#include "trace/BvhStack.h"

#include <utility>

namespace spherepacking
{
inline namespace SPHEREPACKING_ISA
{
/// tMax of a ray whose search is over, since any hit was enough.
constexpr float SearchDone = -1.0f;

/// Replaces the node of `entry` by its nearest child that the ray may hit and pushes the others.
/// Returns whether there is one.
inline bool Descend(
  const Bvh& bvh, const BvhRay& line, float tMax, BvhStack& stack, BvhStack::Entry& entry)
{
  const BvhNode& node = bvh.Nodes[entry.Child];
  float tMin[BvhNode::Width];
  unsigned hit = line.Test(node, tMin, tMax);
  if (hit == 0)
  {
    return false;
  }
  const int bottom = stack.Number;
  const int first = __builtin_ctz(hit);
  entry = { node.Children[first], tMin[first], 0 };
  // Most often that was all.
  for (hit &= hit - 1; hit != 0; hit &= hit - 1)
  {
    const int i = __builtin_ctz(hit);
    BvhStack::Entry other = { node.Children[i], tMin[i], 0 };
    if (other.Depth < entry.Depth)
    {
      std::swap(entry, other);
    }
    stack.Insert(bottom, other);
  }
  return true;
}

/// Intersects a ray with the spheres of a leaf and lowers tMax. RayT is PrimaryRay or SecondaryRay.
template <typename RayT>
inline void IntersectLeaf(const Bvh& bvh, const SphereArrays& spheres, const Ray& ray,
  const BvhRay& line, double inverseSquare, const RayT& kind, const BvhLeaf& leaf, Hit& hit,
  float& tMax)
{
  unsigned candidates = line.Test(bvh, leaf, RayT::CenterMayBeBehind, tMax);
  if (candidates == 0)
  {
    return;
  }
  for (; candidates != 0; candidates &= candidates - 1)
  {
    const int i = __builtin_ctz(candidates);
    const Sphere sphere = bvh.Exact ? leaf.At(i) : spheres[leaf.Ids[i]];
    hit.Offer(kind.Hit(ray, sphere, inverseSquare, leaf.Ids[i]), leaf.Ids[i], sphere);
  }
  tMax = RayT::AnyHit && hit.Id >= 0 ? SearchDone : line.Scaled(hit.T);
}

/// Traverses the subtree of a child: the root, or one that the ray is known to reach.
template <typename RayT>
inline void TraverseFrom(const Bvh& bvh, const SphereArrays& spheres, const Ray& ray,
  const BvhRay& line, double inverseSquare, const RayT& kind, std::uint32_t child, Hit& hit,
  float& tMax)
{
  BvhStack stack;
  stack.Entries[stack.Number++] = { child, 0.0f, 0 };
  while (stack.Number > 0)
  {
    BvhStack::Entry entry = stack.Entries[--stack.Number];
    bool found = entry.Depth <= tMax;
    while (found && !BvhChild::IsLeaf(entry.Child))
    {
      found = Descend(bvh, line, tMax, stack, entry);
    }
    if (found)
    {
      IntersectLeaf(bvh, spheres, ray, line, inverseSquare, kind,
        bvh.Leaves[BvhChild::Index(entry.Child)], hit, tMax);
    }
  }
}

/// The closest hit, or any hit if the kind of ray says so (for shadow rays).
template <typename RayT>
inline Hit FirstHit(const Bvh& bvh, const SphereArrays& spheres, const Ray& ray, const RayT& kind)
{
  Hit hit;
  if (!bvh.Nodes.empty())
  {
    const BvhRay line(bvh, ray);
    float tMax = line.Scaled(hit.T);
    TraverseFrom(bvh, spheres, ray, line, InverseSquare(ray), kind, 0, hit, tMax);
  }
  return hit;
}
}
}

#endif
