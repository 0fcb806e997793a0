// SPDX-License-Identifier: BSD-3-Clause
/// Bounds on where the eight boxes of a node, or spheres of a leaf, lie in the picture of a block.
#ifndef BlockProjection_h
#define BlockProjection_h

#include "trace/BlockAxis.h"
#include "trace/CellDepths.h"

namespace spherepacking
{
inline namespace SPHEREPACKING_ISA
{
/// The footprints of eight boxes or spheres: columns and rows of a block that they may cover, the
/// number of the rectangle of cells that these make, and their least depth in the hierarchy's unit.
struct Footprints
{
  static constexpr int Width = 8;

  alignas(32) std::int32_t X0[Width];
  alignas(32) std::int32_t X1[Width];
  alignas(32) std::int32_t Y0[Width];
  alignas(32) std::int32_t Y1[Width];
  alignas(32) std::uint32_t Rectangle[Width];
  alignas(32) float Nearest[Width];

  RayRectangle RaysOf(int i) const
  {
    return { this->X0[i], this->X1[i], this->Y0[i], this->Y1[i] };
  }
};

/// Projects in single precision from the hierarchy's coordinates to pixels from the block's first
/// ray.
///
/// With the functions p = X.c + Dx and w = Z.c + Dz of a point c, where |Z| = 1, the point is seen
/// at x = p in parallel views and at x = p / w in perspective. Points of the ball around c are c +
/// r v with |v| <= 1. In perspective such a point is seen at (p + a) / (w + b) with a = r X.v and
/// b = r Z.v, which differs from p / w by
///
///   (a - x b) / (w + b) = r (X - x Z).v / (w + b) <= r |X - x Z| / (w - r),
///
/// and |X - x Z|^2 = X.X - 2 x X.Z + x^2 Z.Z: the three dot products of BlockAxis.
class BlockProjection
{
public:
  BlockProjection(
    const CameraRays& rays, const CameraProjection& camera, const RayBlock& block, const Bvh& bvh)
    : Parallel(rays.Parallel)
  {
    const double length = std::sqrt(Dot(camera.Z, camera.Z));
    this->Z.Set(camera.Z, 1.0 / length, 0.0, rays.O0, bvh);
    this->PerDepth = bvh.Scale / length;
    this->DepthPerUnit = length / bvh.Scale * (1.0 - 1e-6);
    // In perspective the pictures' coordinates are quotients, whose unit of length cancels out.
    this->SetAxis(this->X, camera.X, camera.Z, block.X0, length, rays, bvh);
    this->SetAxis(this->Y, camera.Y, camera.Z, block.Y0, length, rays, bvh);
  }

  /// Factor from depths to the unit of `Nearest`.
  double DepthScale() const { return this->PerDepth; }

  /// `Nearest` as a depth, rounded down.
  double Depth(float nearest) const { return nearest * this->DepthPerUnit; }

  /// Which boxes may be hit by a ray of the block before `maxDepth`, a bit each.
  unsigned Test(const BvhNode& node, float maxDepth, Footprints& footprints) const
  {
    const Float8 nearest = this->Z.Least(node);
    const Float8 farthest = this->Z.Greatest(node);
    Store(nearest, footprints.Nearest);
    const Int8 ahead = (farthest > 0.0f) & (nearest <= maxDepth);
    // What reaches the plane of the eye may be anywhere.
    const Float8 one = Float8{} + 1.0f;
    const Int8 everywhere = this->Parallel ? Int8{} : nearest <= 1e-6f * farthest;
    const Float8 inverseLeast = this->Parallel ? one : one / (ahead & ~everywhere ? nearest : one);
    const Float8 inverseMost = this->Parallel ? one : one / (ahead ? farthest : one);
    const auto range = [&](const BlockAxis& axis, std::int32_t (&first)[8], std::int32_t (&end)[8])
    {
      const Float8 least = axis.Least(node);
      const Float8 most = axis.Greatest(node);
      return BlockProjection::Cover(least * (least < 0.0f ? inverseLeast : inverseMost),
        most * (most < 0.0f ? inverseMost : inverseLeast), Float8{}, everywhere, first, end);
    };
    const Int8 inX = range(this->X, footprints.X0, footprints.X1);
    const Int8 inY = range(this->Y, footprints.Y0, footprints.Y1);
    BlockProjection::SetRectangles(footprints);
    return Bits(ahead & inX & inY);
  }

  /// Which spheres may be hit by a ray of the block before `maxDepth`, a bit each.
  unsigned Test(const Bvh& bvh, const BvhLeaf& leaf, float maxDepth, Footprints& footprints) const
  {
    Float8 center[3];
    for (int axis = 0; axis < 3; ++axis)
    {
      center[axis] = (Load<Float8>(leaf.Center[axis]) - bvh.LeafCenter[axis]) * bvh.LeafScale;
    }
    const Float8 radius = Load<Float8>(leaf.Radius) * bvh.LeafScale;
    const Float8 depth = this->Z.At(center);
    const Float8 nearest = depth - radius - this->Z.Error;
    Store(nearest, footprints.Nearest);
    const Int8 ahead = (depth + radius + this->Z.Error > 0.0f) & (nearest <= maxDepth);
    const Int8 everywhere = this->Parallel ? Int8{} : nearest <= 1e-6f * depth;
    const Float8 one = Float8{} + 1.0f;
    const Float8 divisor = this->Parallel || Bits(everywhere) == 0xffu ? one : depth;
    const Float8 least = this->Parallel ? one : everywhere ? one : nearest;
    const auto range = [&](const BlockAxis& axis, std::int32_t (&first)[8], std::int32_t (&end)[8])
    {
      const Float8 x = axis.At(center) / divisor;
      const Float8 square = axis.NN + x * (x * axis.ZZ - axis.TwiceNZ);
      const Float8 reach =
        (radius * Sqrt(square > 0.0f ? square : Float8{}) + axis.Error) / least * (1.0f + 1e-5f);
      return BlockProjection::Cover(x, x, reach, everywhere, first, end);
    };
    const Int8 inX = range(this->X, footprints.X0, footprints.X1);
    const Int8 inY = range(this->Y, footprints.Y0, footprints.Y1);
    BlockProjection::SetRectangles(footprints);
    return Bits(ahead & inX & inY);
  }

private:
  void SetAxis(BlockAxis& axis, const Double3& n, const Double3& z, double first, double length,
    const CameraRays& rays, const Bvh& bvh)
  {
    if (rays.Parallel)
    {
      axis.Set(n, 1.0 / bvh.Scale, -first, rays.O0, bvh);
      axis.NN = static_cast<float>(Dot(n, n) / (bvh.Scale * bvh.Scale));
      return;
    }
    Double3 relative;
    for (int i = 0; i < 3; ++i)
    {
      relative[i] = n[i] - first * z[i];
    }
    axis.Set(relative, 1.0 / length, 0.0, rays.O0, bvh);
    const double unit = 1.0 / (length * length);
    axis.NN = static_cast<float>(Dot(relative, relative) * unit);
    axis.TwiceNZ = static_cast<float>(2.0 * Dot(relative, z) * unit);
    axis.ZZ = 1.0f;
  }

  // The first and the last ray of the block from low - reach to high + reach; a bit where there is
  // one.
  static Int8 Cover(const Float8& low, const Float8& high, const Float8& reach,
    const Int8& everywhere, std::int32_t (&first)[8], std::int32_t (&last)[8])
  {
    const auto rounding = [](const Float8& x) { return 1e-6f * (x < 0.0f ? -x : x) + 1e-3f; };
    const Float8 begin = low - reach - rounding(low);
    const Float8 end = high + reach + rounding(high);
    const Float8 zero = Float8{};
    const Float8 side = zero + static_cast<float>(RayBlock::Side);
    // What is not left of -1 or right of 16 keeps its value, so that conversion is defined.
    const Float8 from = everywhere ? zero
      : begin > 0.0f               ? (begin < side ? begin : side)
                                   : zero - 1.0f;
    const Float8 to = everywhere ? side - 1.0f
      : end < side - 1.0f        ? (end > -1.0f ? end : zero - 1.0f)
                                 : side - 1.0f;
    const Int8 a = everywhere ? Int8{} : __builtin_convertvector(from + 1.0f, Int8);
    const Int8 b = __builtin_convertvector(to + 1.0f, Int8) - 1;
    Store(a, first);
    Store(b, last);
    return a <= b;
  }

  static void SetRectangles(Footprints& footprints)
  {
    Store(CellDepths::Rectangle(Load<Int8>(footprints.X0), Load<Int8>(footprints.X1),
            Load<Int8>(footprints.Y0), Load<Int8>(footprints.Y1)),
      footprints.Rectangle);
  }

  bool Parallel;
  double PerDepth;
  double DepthPerUnit;
  BlockAxis X;
  BlockAxis Y;
  BlockAxis Z;
};
}
}

#endif
