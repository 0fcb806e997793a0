// SPDX-License-Identifier: BSD-3-Clause
/// What a block of rays and its quarters can see, against the eight boxes of a node of the
/// hierarchy at once.
#ifndef Frustum_h
#define Frustum_h

#include "kernels/Bvh.h"
#include "kernels/RayBlock.h"

namespace spherepacking
{
inline namespace SPHEREPACKING_ISA
{
/// Boxes of a node that may be seen, a bit each.
struct SeenBoxes
{
  unsigned All;
  unsigned Halves[2][2]; ///< which of them in the left and right, and the lower and upper half
  float Depth[BvhNode::Width]; ///< the least of each

  /// In which quarters box i may be seen, a bit each, as RayBlock counts them.
  unsigned QuartersOf(int i) const
  {
    const unsigned row = (this->Halves[0][0] >> i & 1u) | (this->Halves[0][1] >> i & 1u) << 1;
    return (this->Halves[1][0] >> i & 1u) * row | (this->Halves[1][1] >> i & 1u) * (row << 2);
  }
};

/// Half spaces n.p + d >= 0 in the hierarchy's coordinates: the four sides, what is ahead, and the
/// right and the upper half.
class Frustum
{
public:
  Frustum(const CameraRays& rays, const Screen& screen, const RayBlock& block, const Bvh& bvh)
  {
    // The sides lie in the middle between rays of this block and of the next.
    const double x0 = block.X0 - 0.5;
    const double y0 = block.Y0 - 0.5;
    constexpr double side = RayBlock::Side;
    const Ray middle = rays.At(x0 + 0.5 * side, y0 + 0.5 * side);
    const Ray low = rays.At(x0, y0);
    const Ray high = rays.At(x0 + side, y0 + side);
    const Vector& alongX = rays.Parallel ? rays.OX : rays.DX;
    const Vector& alongY = rays.Parallel ? rays.OY : rays.DY;
    this->AddSide(0, low, alongY, middle, bvh);
    this->AddSide(1, high, alongY, middle, bvh);
    this->AddSide(2, low, alongX, middle, bvh);
    this->AddSide(3, high, alongX, middle, bvh);
    this->Add(Ahead, screen.Z, middle.O, bvh);
    this->PerDepth = bvh.Scale / this->Length;
    this->DepthPerScaled = this->Length / bvh.Scale;
    this->AddSide(Right, middle, alongY, high, bvh);
    this->AddSide(Upper, middle, alongX, high, bvh);
  }

  /// A depth as the least depths of Test() are measured, rounded up.
  float ScaledDepth(double depth) const
  {
    return static_cast<float>(std::min(depth * this->PerDepth, 3e38)) * (1.0f + 1e-6f);
  }

  /// A scaled depth as a depth, rounded down.
  double Depth(float scaled) const { return scaled * (this->DepthPerScaled * (1.0 - 1e-6)); }

  /// Which of the eight boxes may be seen before the depth `last`.
  void Test(const BvhNode& node, float last, SeenBoxes& seen) const
  {
    Int8 outside = {};
    for (int plane = 0; plane <= Ahead; ++plane)
    {
      outside |= this->Corners(plane, node, true) + this->D[plane] < 0.0f;
    }
    const Float8 nearest = this->Corners(Ahead, node, false) + this->NearD[Ahead];
    Store(nearest, seen.Depth);
    seen.All = ~Bits(outside | (nearest > last)) & 0xffu;
    for (int axis = 0; axis < 2; ++axis)
    {
      const int plane = Right + axis;
      seen.Halves[axis][0] = Bits(this->Corners(plane, node, false) + this->NearD[plane] <= 0.0f);
      seen.Halves[axis][1] = Bits(this->Corners(plane, node, true) + this->D[plane] >= 0.0f);
    }
  }

private:
  static constexpr int Ahead = 4;
  static constexpr int Right = 5;
  static constexpr int Upper = 6;
  static constexpr int Planes = 7;

  // The products of the plane's normal with the corners that lie farthest along it, or nearest.
  Float8 Corners(int plane, const BvhNode& node, bool farthest) const
  {
    Float8 sum = {};
    for (int axis = 0; axis < 3; ++axis)
    {
      const float n = this->N[plane][axis];
      sum += n * Load<Float8>((n > 0.0f) == farthest ? node.High[axis] : node.Low[axis]);
    }
    return sum;
  }

  // The plane through a ray and a direction; the middle ray is inside.
  void AddSide(int plane, const Ray& ray, const Vector& along, const Ray& middle, const Bvh& bvh)
  {
    Vector normal;
    Cross(ray.D, along, normal);
    double inside = 0.0;
    for (int axis = 0; axis < 3; ++axis)
    {
      inside += normal[axis] * (middle.O[axis] - ray.O[axis] + middle.D[axis] - ray.D[axis]);
    }
    if (inside < 0.0)
    {
      normal[0] = -normal[0];
      normal[1] = -normal[1];
      normal[2] = -normal[2];
    }
    this->Add(plane, normal, ray.O, bvh);
  }

  // Coordinates are between -1 and 1 and the normal has the length 1, so that a few roundings of 1
  // and of the offset are what a sum may be wrong by.
  void Add(int plane, const Vector& normal, const Vector& origin, const Bvh& bvh)
  {
    this->Length = std::sqrt(Dot(normal, normal));
    double offset = 0.0;
    for (int axis = 0; axis < 3; ++axis)
    {
      this->N[plane][axis] = static_cast<float>(normal[axis] / this->Length);
      offset += normal[axis] / this->Length * (bvh.Center[axis] - origin[axis]) * bvh.Scale;
    }
    const double margin = 1e-6 * (1.0 + std::abs(offset));
    this->D[plane] = static_cast<float>(offset + margin);
    this->NearD[plane] = static_cast<float>(offset - margin);
  }

  float N[Planes][3];
  float D[Planes];
  float NearD[Planes];
  double Length;
  double PerDepth;
  double DepthPerScaled;
};
}
}

#endif
