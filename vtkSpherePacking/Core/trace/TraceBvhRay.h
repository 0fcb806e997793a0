// SPDX-License-Identifier: BSD-3-Clause
/// The first hit of a single ray through the hierarchy.
#ifndef TraceBvhRay_h
#define TraceBvhRay_h

#include "trace/TraceBvhBlock.h"

#include <utility>

namespace spherepacking
{
inline namespace SPHEREPACKING_ISA
{
/// The planes through which rays enter and leave the boxes of a node.
struct BvhPlanes
{
  const float* In[3];
  const float* Out[3];

  /// `up` says along which axes the rays go up.
  BvhPlanes(const BvhNode& node, const bool (&up)[3])
  {
    for (int axis = 0; axis < 3; ++axis)
    {
      this->In[axis] = up[axis] ? node.Low[axis] : node.High[axis];
      this->Out[axis] = up[axis] ? node.High[axis] : node.Low[axis];
    }
  }
};

/// A ray in the hierarchy's coordinates, single precision, and what it may miss.
///
/// The origin is moved to where the ray enters the scene, so that all coordinates are 2 at most and
/// rounding moves the ray by some 10^-7. Boxes and spheres are taken larger by Margin instead of
/// widening the interval of t (Ize, "Robust BVH Ray Traversal", 2013), since the origin is rounded
/// as well.
class alignas(64) BvhRay
{
public:
  BvhRay() = default;

  BvhRay(const Bvh& bvh, const Ray& ray)
  {
    const double largest =
      std::max(std::abs(ray.D[0]), std::max(std::abs(ray.D[1]), std::abs(ray.D[2])));
    const double inverseLargest = 1.0 / largest;
    double o[3];
    double d[3];
    double enter = 0.0;
    for (int axis = 0; axis < 3; ++axis)
    {
      o[axis] = (ray.O[axis] - bvh.Center[axis]) * bvh.Scale;
      d[axis] = ray.D[axis] * inverseLargest;
      if (std::abs(o[axis]) > 1.0 && o[axis] * d[axis] < 0.0)
      {
        enter = std::max(enter, (std::abs(o[axis]) - 1.0) / std::abs(d[axis]));
      }
    }
    for (int axis = 0; axis < 3; ++axis)
    {
      this->O[axis] = static_cast<float>(o[axis] + enter * d[axis]);
      this->D[axis] = static_cast<float>(d[axis]);
      // So that no product is 0 times infinity.
      const float away =
        std::abs(this->D[axis]) > Least ? this->D[axis] : std::copysign(Least, this->D[axis]);
      this->Inverse[axis] = 1.0f / away;
      const bool up = away > 0.0f;
      this->Up[axis] = up;
      this->InO[axis] = this->O[axis] + (up ? Margin : -Margin);
      this->OutO[axis] = this->O[axis] - (up ? Margin : -Margin);
    }
    this->InverseSquare =
      1.0f / (this->D[0] * this->D[0] + this->D[1] * this->D[1] + this->D[2] * this->D[2]);
    this->Enter = enter;
    this->PerT = largest * bvh.Scale;
  }

  /// Where t lies on this ray, rounded up.
  float Scaled(double t) const
  {
    return static_cast<float>(std::min(t * this->PerT - this->Enter, 1e30)) + Margin;
  }

  /// Which of the eight boxes the ray may hit before `last`, a bit each, and where it enters them.
  unsigned Test(const BvhNode& node, float (&depth)[BvhNode::Width], float last) const
  {
    Float8 enter;
    const unsigned seen = this->Test(BvhPlanes(node, this->Up), last, enter);
    Store(enter, depth);
    return seen;
  }

  unsigned Test(const BvhPlanes& planes, float last, Float8& enter) const
  {
    enter = Float8{};
    Float8 leave = Float8{} + last;
    for (int axis = 0; axis < 3; ++axis)
    {
      const Float8 in = (Load<Float8>(planes.In[axis]) - this->InO[axis]) * this->Inverse[axis];
      const Float8 out = (Load<Float8>(planes.Out[axis]) - this->OutO[axis]) * this->Inverse[axis];
      enter = in > enter ? in : enter;
      leave = out < leave ? out : leave;
    }
    return Bits(enter <= leave * (1.0f + 1e-6f));
  }

  /// Which of the spheres of a leaf the line may hit before `last`, and if not `behind`, from the
  /// origin on.
  unsigned Test(const Bvh& bvh, const BvhLeaf& leaf, bool behind, float last) const
  {
    Float8 f[3];
    Float8 middle = Float8{};
    for (int axis = 0; axis < 3; ++axis)
    {
      f[axis] =
        (Load<Float8>(leaf.Center[axis]) - bvh.LeafCenter[axis]) * bvh.LeafScale - this->O[axis];
      middle += f[axis] * this->D[axis];
    }
    middle *= this->InverseSquare;
    Float8 square = Float8{};
    for (int axis = 0; axis < 3; ++axis)
    {
      const Float8 l = f[axis] - middle * this->D[axis];
      square += l * l;
    }
    const Float8 reach = Load<Float8>(leaf.Radius) * bvh.LeafScale + Margin;
    // D is no shorter than 1, so that half of a chord is no more than the radius.
    const Int8 between = (middle - reach <= last) & (middle > (behind ? -1e30f : -Margin));
    return Bits(between & (reach > 0.0f) & (square <= reach * reach * (1.0f + 1e-6f)));
  }

  /// Bit by bit, along which axes the ray goes up.
  unsigned Octant() const
  {
    return static_cast<unsigned>(this->Up[0]) | static_cast<unsigned>(this->Up[1]) << 1 |
      static_cast<unsigned>(this->Up[2]) << 2;
  }

private:
  static constexpr float Margin = 2e-6f;
  static constexpr float Least = 1e-20f;

  float InO[3]; // the origin, moved away from what it may miss
  float OutO[3];
  float Inverse[3];
  float O[3];
  float D[3];

  float InverseSquare;
  bool Up[3]; // whether the ray enters boxes through the lower plane
  double Enter;
  double PerT;
};

/// What a ray may still reach that needs no other hit.
constexpr float NothingLeft = -1.0f;

/// Children of a node that the ray may hit: the nearest one takes the place of `entry`, all others
/// wait on the stack. Returns whether there is one.
inline bool Descend(
  const Bvh& bvh, const BvhRay& line, float last, BvhStack& stack, BvhStack::Entry& entry)
{
  const BvhNode& node = bvh.Nodes[entry.Child];
  float depth[BvhNode::Width];
  unsigned seen = line.Test(node, depth, last);
  if (seen == 0)
  {
    return false;
  }
  const int bottom = stack.Number;
  const int first = __builtin_ctz(seen);
  entry = { node.Children[first], depth[first], 0 };
  // Most often that was all.
  for (seen &= seen - 1; seen != 0; seen &= seen - 1)
  {
    const int i = __builtin_ctz(seen);
    BvhStack::Entry other = { node.Children[i], depth[i], 0 };
    if (other.Depth < entry.Depth)
    {
      std::swap(entry, other);
    }
    stack.Insert(bottom, other);
  }
  return true;
}

/// Tests a ray against the spheres of a leaf.
template <typename SurfaceT>
inline void OfferLeaf(const Bvh& bvh, const SphereArrays& spheres, const Ray& ray,
  const BvhRay& line, double inverseSquare, const SurfaceT& surface, const BvhLeaf& leaf, Hit& hit,
  float& last)
{
  unsigned seen = line.Test(bvh, leaf, SurfaceT::Behind, last);
  if (seen == 0)
  {
    return;
  }
  for (; seen != 0; seen &= seen - 1)
  {
    const int i = __builtin_ctz(seen);
    const Sphere sphere = bvh.Exact ? leaf.At(i) : spheres[leaf.Ids[i]];
    hit.Offer(surface.Hit(ray, sphere, inverseSquare, leaf.Ids[i]), leaf.Ids[i], sphere);
  }
  last = SurfaceT::Any && hit.Id >= 0 ? NothingLeft : line.Scaled(hit.T);
}

/// Goes on from a child, the root or one that the ray is known to reach.
template <typename SurfaceT>
inline void HitBelow(const Bvh& bvh, const SphereArrays& spheres, const Ray& ray,
  const BvhRay& line, double inverseSquare, const SurfaceT& surface, std::uint32_t child, Hit& hit,
  float& last)
{
  BvhStack stack;
  stack.Entries[stack.Number++] = { child, 0.0f, 0 };
  while (stack.Number > 0)
  {
    BvhStack::Entry entry = stack.Entries[--stack.Number];
    bool found = entry.Depth <= last;
    while (found && !BvhChild::IsLeaf(entry.Child))
    {
      found = Descend(bvh, line, last, stack, entry);
    }
    if (found)
    {
      OfferLeaf(bvh, spheres, ray, line, inverseSquare, surface,
        bvh.Leaves[BvhChild::Index(entry.Child)], hit, last);
    }
  }
}

template <typename SurfaceT>
inline Hit FirstHit(
  const Bvh& bvh, const SphereArrays& spheres, const Ray& ray, const SurfaceT& surface)
{
  Hit hit;
  if (!bvh.Nodes.empty())
  {
    const BvhRay line(bvh, ray);
    float last = line.Scaled(hit.T);
    HitBelow(bvh, spheres, ray, line, InverseSquare(ray), surface, 0, hit, last);
  }
  return hit;
}
}
}

#endif
