// SPDX-License-Identifier: BSD-3-Clause
/// The first hit of a single ray through the hierarchy.
#ifndef TraceRay_h
#define TraceRay_h

#include "kernels/TraceBvh.h"

namespace spherepacking
{
inline namespace SPHEREPACKING_ISA
{
/// A ray in the hierarchy's coordinates, single precision, and what it may miss.
///
/// The origin is moved to where the ray enters the scene, so that all coordinates are 2 at most and
/// rounding moves the ray by some 10^-7. Boxes and spheres are taken larger by Margin instead of
/// widening the interval of t (Ize, "Robust BVH Ray Traversal", 2013), since the origin is rounded
/// as well.
class BvhRay
{
public:
  BvhRay(const Bvh& bvh, const Ray& ray)
  {
    double largest = 0.0;
    for (const double d : ray.D)
    {
      largest = std::max(largest, std::abs(d));
    }
    double enter = 0.0;
    for (int axis = 0; axis < 3; ++axis)
    {
      const double o = (ray.O[axis] - bvh.Center[axis]) * bvh.Scale;
      const double d = ray.D[axis] / largest;
      if (std::abs(o) > 1.0 && o * d < 0.0)
      {
        enter = std::max(enter, (std::abs(o) - 1.0) / std::abs(d));
      }
    }
    for (int axis = 0; axis < 3; ++axis)
    {
      const double o = (ray.O[axis] - bvh.Center[axis]) * bvh.Scale;
      const double d = ray.D[axis] / largest;
      this->O[axis] = static_cast<float>(o + enter * d);
      this->D[axis] = static_cast<float>(d);
      // So that no product is 0 times infinity.
      const float away =
        std::abs(this->D[axis]) > Least ? this->D[axis] : std::copysign(Least, this->D[axis]);
      this->Inverse[axis] = 1.0f / away;
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
    Float8 enter = Float8{};
    Float8 leave = Float8{} + last;
    for (int axis = 0; axis < 3; ++axis)
    {
      const Float8 low = Load<Float8>(node.Low[axis]) - (this->O[axis] + Margin);
      const Float8 high = Load<Float8>(node.High[axis]) - (this->O[axis] - Margin);
      const bool up = this->Inverse[axis] > 0.0f;
      const Float8 in = (up ? low : high) * this->Inverse[axis];
      const Float8 out = (up ? high : low) * this->Inverse[axis];
      enter = in > enter ? in : enter;
      leave = out < leave ? out : leave;
    }
    Store(enter, depth);
    return Bits(enter <= leave * (1.0f + 1e-6f));
  }

  /// Which of the spheres of a leaf the line may hit.
  unsigned Test(const Bvh& bvh, const BvhLeaf& leaf) const
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
    return Bits((reach > 0.0f) & (square <= reach * reach * (1.0f + 1e-6f)));
  }

private:
  static constexpr float Margin = 2e-6f;
  static constexpr float Least = 1e-20f;

  float O[3];
  float D[3];
  float Inverse[3];
  float InverseSquare;
  double Enter;
  double PerT;
};

inline Hit FirstHit(const Bvh& bvh, const SphereArrays& spheres, const Ray& ray)
{
  Hit hit;
  if (bvh.Nodes.empty())
  {
    return hit;
  }
  const double inverseSquare = InverseSquare(ray);
  const BvhRay line(bvh, ray);
  float last = line.Scaled(hit.T);
  BvhStack stack;
  stack.Entries[stack.Number++] = { 0, 0.0f, 0 };
  while (stack.Number > 0)
  {
    const BvhStack::Entry entry = stack.Entries[--stack.Number];
    if (entry.Depth > last)
    {
      continue;
    }
    if (!BvhChild::IsLeaf(entry.Child))
    {
      const BvhNode& node = bvh.Nodes[entry.Child];
      float depth[BvhNode::Width];
      const int bottom = stack.Number;
      for (unsigned seen = line.Test(node, depth, last); seen != 0; seen &= seen - 1)
      {
        const int i = __builtin_ctz(seen);
        stack.Insert(bottom, { node.Children[i], depth[i], 0 });
      }
      continue;
    }
    const BvhLeaf& leaf = bvh.Leaves[BvhChild::Index(entry.Child)];
    for (unsigned seen = line.Test(bvh, leaf); seen != 0; seen &= seen - 1)
    {
      const int i = __builtin_ctz(seen);
      const Sphere sphere = bvh.Exact ? leaf.At(i) : spheres[leaf.Ids[i]];
      hit.Offer(HitSphere(ray, sphere, inverseSquare), leaf.Ids[i]);
    }
    last = line.Scaled(hit.T);
  }
  return hit;
}
}
}

#endif
