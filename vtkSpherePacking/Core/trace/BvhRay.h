// SPDX-License-Identifier: BSD-3-Clause
#ifndef BvhRay_h
#define BvhRay_h

#include "accel/Bvh.h"
#include "trace/RaySphere.h"

#include <algorithm>
#include <cmath>

namespace spherepacking
{
inline namespace SPHEREPACKING_ISA
{
/// The planes through which rays enter and leave the boxes of a node.
struct BvhSlabs
{
  const float* In[3];
  const float* Out[3];

  /// `up` says along which axes the rays go up.
  BvhSlabs(const BvhNode& node, const bool (&up)[3])
  {
    for (int axis = 0; axis < 3; ++axis)
    {
      this->In[axis] = up[axis] ? node.Low[axis] : node.High[axis];
      this->Out[axis] = up[axis] ? node.High[axis] : node.Low[axis];
    }
  }
};

/// A ray in the hierarchy's coordinates, single precision, and the conservative tests of boxes and
/// spheres: what they reject, the exact test misses.
///
/// The origin is moved to where the ray enters the scene, so that all coordinates are 2 at most and
/// rounding moves the ray by some 10^-7. Boxes and spheres are enlarged by Margin instead of
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

  /// tMax of this ray for a t of the original one, rounded up.
  float Scaled(double t) const
  {
    return static_cast<float>(std::min(t * this->PerT - this->Enter, 1e30)) + Margin;
  }

  /// Which of the eight boxes the ray may hit before tMax, a bit each, and where it enters them.
  unsigned Test(const BvhNode& node, float (&tMin)[BvhNode::Width], float tMax) const
  {
    Float8 enter;
    const unsigned hit = this->Test(BvhSlabs(node, this->Up), tMax, enter);
    Store(enter, tMin);
    return hit;
  }

  unsigned Test(const BvhSlabs& slabs, float tMax, Float8& enter) const
  {
    enter = Float8{};
    Float8 leave = Float8{} + tMax;
    for (int axis = 0; axis < 3; ++axis)
    {
      const Float8 in = (Load<Float8>(slabs.In[axis]) - this->InO[axis]) * this->Inverse[axis];
      const Float8 out = (Load<Float8>(slabs.Out[axis]) - this->OutO[axis]) * this->Inverse[axis];
      enter = in > enter ? in : enter;
      leave = out < leave ? out : leave;
    }
    return Bits(enter <= leave * (1.0f + 1e-6f));
  }

  /// Which of the spheres of a leaf the line may hit before tMax, a bit each; unless
  /// `centerMayBeBehind`, only those whose chord has its middle in front of the origin.
  unsigned Test(const Bvh& bvh, const BvhLeaf& leaf, bool centerMayBeBehind, float tMax) const
  {
    Float8 f[3];
    for (int axis = 0; axis < 3; ++axis)
    {
      f[axis] =
        (Load<Float8>(leaf.Center[axis]) - bvh.LeafCenter[axis]) * bvh.LeafScale - this->O[axis];
    }
    const Chord<Float8> chord(f, this->D, this->InverseSquare);
    const Float8 reach = Load<Float8>(leaf.Radius) * bvh.LeafScale + Margin;
    // D is no shorter than 1, so that half of a chord is no more than the radius.
    const Int8 between =
      (chord.T0 - reach <= tMax) & (chord.T0 > (centerMayBeBehind ? -1e30f : -Margin));
    return Bits(between & (reach > 0.0f) & (chord.Square <= reach * reach * (1.0f + 1e-6f)));
  }

  /// A bit for each axis along which the ray goes up.
  unsigned Octant() const
  {
    return static_cast<unsigned>(this->Up[0]) | static_cast<unsigned>(this->Up[1]) << 1 |
      static_cast<unsigned>(this->Up[2]) << 2;
  }

private:
  static constexpr float Margin = 2e-6f;
  static constexpr float Least = 1e-20f;

  float InO[3]; // the origin, moved away from the planes by Margin
  float OutO[3];
  float Inverse[3];
  float O[3];
  float D[3];

  float InverseSquare;
  bool Up[3]; // whether the ray enters boxes through the lower plane
  double Enter;
  double PerT;
};
}
}

#endif
