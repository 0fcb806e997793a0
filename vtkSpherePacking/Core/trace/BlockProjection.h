// SPDX-License-Identifier: BSD-3-Clause
/// Where the eight boxes of a node, or spheres of a leaf, are in the picture of a block of rays.
#ifndef BlockProjection_h
#define BlockProjection_h

#include "trace/BlockAxis.h"
#include "trace/CellDepths.h"

namespace spherepacking
{
inline namespace SPHEREPACKING_ISA
{
/// Columns and rows of a block that each of eight things may cover, the rectangle of cells that
/// they make, and the least depth of each in the hierarchy's unit.
struct BlockParts
{
  static constexpr int Width = 8;

  alignas(32) std::int32_t X0[Width];
  alignas(32) std::int32_t X1[Width];
  alignas(32) std::int32_t Y0[Width];
  alignas(32) std::int32_t Y1[Width];
  alignas(32) std::uint32_t Rectangle[Width];
  alignas(32) float Nearest[Width];

  BlockPart Of(int i) const { return { this->X0[i], this->X1[i], this->Y0[i], this->Y1[i] }; }
};

/// Single precision in the hierarchy's coordinates, with x and y in pixels from the block's first
/// ray.
class BlockScreen
{
public:
  BlockScreen(const CameraRays& rays, const Screen& screen, const RayBlock& block, const Bvh& bvh)
    : Parallel(rays.Parallel)
  {
    const double length = std::sqrt(Dot(screen.Z, screen.Z));
    this->Z.Set(screen.Z, 1.0 / length, 0.0, rays.O0, bvh);
    this->PerDepth = bvh.Scale / length;
    this->DepthPerUnit = length / bvh.Scale * (1.0 - 1e-6);
    // In perspective the pictures' coordinates are quotients, whose unit of length cancels out.
    this->SetAxis(this->X, screen.X, screen.Z, block.X0, length, rays, bvh);
    this->SetAxis(this->Y, screen.Y, screen.Z, block.Y0, length, rays, bvh);
  }

  /// What a depth is multiplied by to be compared with `Nearest`.
  double DepthScale() const { return this->PerDepth; }

  /// `Nearest` as a depth, rounded down.
  double Depth(float nearest) const { return nearest * this->DepthPerUnit; }

  /// Which boxes may be hit by a ray of the block before `last`, a bit each.
  unsigned Test(const BvhNode& node, float last, BlockParts& parts) const
  {
    const Float8 nearest = this->Z.Least(node);
    const Float8 farthest = this->Z.Greatest(node);
    Store(nearest, parts.Nearest);
    const Int8 ahead = (farthest > 0.0f) & (nearest <= last);
    // What reaches the plane of the eye may be anywhere.
    const Float8 one = Float8{} + 1.0f;
    const Int8 everywhere = this->Parallel ? Int8{} : nearest <= 1e-6f * farthest;
    const Float8 inverseLeast = this->Parallel ? one : one / (ahead & ~everywhere ? nearest : one);
    const Float8 inverseMost = this->Parallel ? one : one / (ahead ? farthest : one);
    const auto range = [&](const BlockAxis& axis, std::int32_t (&first)[8], std::int32_t (&end)[8])
    {
      const Float8 least = axis.Least(node);
      const Float8 most = axis.Greatest(node);
      return BlockScreen::Cover(least * (least < 0.0f ? inverseLeast : inverseMost),
        most * (most < 0.0f ? inverseMost : inverseLeast), Float8{}, everywhere, first, end);
    };
    const Int8 inX = range(this->X, parts.X0, parts.X1);
    const Int8 inY = range(this->Y, parts.Y0, parts.Y1);
    BlockScreen::SetRectangles(parts);
    return Bits(ahead & inX & inY);
  }

  /// Which spheres may be hit by a ray of the block before `last`, a bit each.
  ///
  /// In perspective the ball's points are at (p + a) / (w + b) with |a - b p/w| <= r |X - (p/w) Z|
  /// and b >= -r |Z|, so that is how far they are from the centre's picture p / w at most.
  unsigned Test(const Bvh& bvh, const BvhLeaf& leaf, float last, BlockParts& parts) const
  {
    Float8 center[3];
    for (int axis = 0; axis < 3; ++axis)
    {
      center[axis] = (Load<Float8>(leaf.Center[axis]) - bvh.LeafCenter[axis]) * bvh.LeafScale;
    }
    const Float8 radius = Load<Float8>(leaf.Radius) * bvh.LeafScale;
    const Float8 depth = this->Z.Dot(center);
    const Float8 nearest = depth - radius - this->Z.Error;
    Store(nearest, parts.Nearest);
    const Int8 ahead = (depth + radius + this->Z.Error > 0.0f) & (nearest <= last);
    const Int8 everywhere = this->Parallel ? Int8{} : nearest <= 1e-6f * depth;
    const Float8 one = Float8{} + 1.0f;
    const Float8 divisor = this->Parallel || Bits(everywhere) == 0xffu ? one : depth;
    const Float8 least = this->Parallel ? one : everywhere ? one : nearest;
    const auto range = [&](const BlockAxis& axis, std::int32_t (&first)[8], std::int32_t (&end)[8])
    {
      const Float8 x = axis.Dot(center) / divisor;
      const Float8 square = axis.Square + x * (x * axis.SquareZ - axis.Mixed);
      const Float8 reach =
        (radius * Sqrt(square > 0.0f ? square : Float8{}) + axis.Error) / least * (1.0f + 1e-5f);
      return BlockScreen::Cover(x, x, reach, everywhere, first, end);
    };
    const Int8 inX = range(this->X, parts.X0, parts.X1);
    const Int8 inY = range(this->Y, parts.Y0, parts.Y1);
    BlockScreen::SetRectangles(parts);
    return Bits(ahead & inX & inY);
  }

private:
  void SetAxis(BlockAxis& axis, const Vector& covector, const Vector& depth, double first,
    double length, const CameraRays& rays, const Bvh& bvh)
  {
    if (rays.Parallel)
    {
      axis.Set(covector, 1.0 / bvh.Scale, -first, rays.O0, bvh);
      axis.Square =
        static_cast<float>(spherepacking::Dot(covector, covector) / (bvh.Scale * bvh.Scale));
      return;
    }
    Vector relative;
    for (int i = 0; i < 3; ++i)
    {
      relative[i] = covector[i] - first * depth[i];
    }
    axis.Set(relative, 1.0 / length, 0.0, rays.O0, bvh);
    const double unit = 1.0 / (length * length);
    axis.Square = static_cast<float>(spherepacking::Dot(relative, relative) * unit);
    axis.Mixed = static_cast<float>(2.0 * spherepacking::Dot(relative, depth) * unit);
    axis.SquareZ = 1.0f;
  }

  // The first and the last ray inside the block from low - reach to high + reach; which there are.
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

  static void SetRectangles(BlockParts& parts)
  {
    Store(CellDepths::Rectangle(
            Load<Int8>(parts.X0), Load<Int8>(parts.X1), Load<Int8>(parts.Y0), Load<Int8>(parts.Y1)),
      parts.Rectangle);
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
