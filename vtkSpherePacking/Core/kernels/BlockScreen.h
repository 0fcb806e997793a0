// SPDX-License-Identifier: BSD-3-Clause
/// Where the eight spheres of a leaf are in the picture of a block of rays.
#ifndef BlockScreen_h
#define BlockScreen_h

#include "kernels/Bvh.h"
#include "kernels/RayBlock.h"

namespace spherepacking
{
inline namespace SPHEREPACKING_ISA
{
/// Columns and rows of a block that each sphere of a leaf may cover, and the least depth at which
/// it may be hit, as that of Frustum.
struct LeafParts
{
  alignas(32) std::int32_t X0[BvhLeaf::Width];
  alignas(32) std::int32_t X1[BvhLeaf::Width];
  alignas(32) std::int32_t Y0[BvhLeaf::Width];
  alignas(32) std::int32_t Y1[BvhLeaf::Width];
  alignas(32) float Nearest[BvhLeaf::Width];

  BlockPart Of(int i) const { return { this->X0[i], this->X1[i], this->Y0[i], this->Y1[i] }; }
};

/// Single precision in the hierarchy's coordinates, with x and y in pixels from the block's first
/// ray. Errors are taken into account as multiples of 10^-6 of what was added up, some ten
/// roundings.
class BlockScreen
{
public:
  BlockScreen(const CameraRays& rays, const Screen& screen, const RayBlock& block, const Bvh& bvh)
    : Parallel(rays.Parallel)
  {
    const double length = std::sqrt(Dot(screen.Z, screen.Z));
    this->Z.Set(screen.Z, 1.0 / length, 0.0, rays.O0, bvh);
    // In perspective the pictures' coordinates are quotients, whose unit of length cancels out.
    this->SetAxis(this->X, screen.X, screen.Z, block.X0, length, rays, bvh);
    this->SetAxis(this->Y, screen.Y, screen.Z, block.Y0, length, rays, bvh);
  }

  /// Which spheres may be hit by a ray of the block before `last`, a depth of Frustum, a bit each.
  ///
  /// In perspective the ball's points are at (p + a) / (w + b) with |a - b p/w| <= r |X - (p/w) Z|
  /// and b >= -r |Z|, so that is how far they are from the centre's picture p / w at most.
  unsigned Test(const Bvh& bvh, const BvhLeaf& leaf, float last, LeafParts& parts) const
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
    // What reaches the plane of the eye may be anywhere.
    const Int8 everywhere = this->Parallel ? Int8{} : nearest <= 1e-6f * depth;
    const Float8 one = Float8{} + 1.0f;
    const Float8 divisor = this->Parallel || Bits(everywhere) == 0xffu ? one : depth;
    const Float8 least = this->Parallel ? one : everywhere ? one : nearest;
    const Int8 inX =
      this->Range(this->X, center, radius, divisor, least, everywhere, parts.X0, parts.X1);
    const Int8 inY =
      this->Range(this->Y, center, radius, divisor, least, everywhere, parts.Y0, parts.Y1);
    return Bits(ahead & inX & inY);
  }

private:
  // A covector, and its product with the middle of the hierarchy as seen from the eye.
  struct Axis
  {
    float N[3];
    float D;
    float Error;
    // Of the covector with itself and with that of the depth, and of that with itself; the latter
    // two only where the depth is divided by.
    float Square = 0.0f;
    float Mixed = 0.0f;
    float SquareZ = 0.0f;

    void Set(const Vector& covector, double scale, double offset, const Vector& eye, const Bvh& bvh)
    {
      double d = 0.0;
      double length = 0.0;
      for (int axis = 0; axis < 3; ++axis)
      {
        const double n = covector[axis] * scale;
        this->N[axis] = static_cast<float>(n);
        d += n * (bvh.Center[axis] - eye[axis]) * bvh.Scale;
        length += std::abs(n);
      }
      this->D = static_cast<float>(d + offset);
      this->Error = static_cast<float>(1e-6 * (length + std::abs(d + offset)));
    }

    Float8 Dot(const Float8 (&center)[3]) const
    {
      return this->N[0] * center[0] + this->N[1] * center[1] + this->N[2] * center[2] + this->D;
    }
  };

  void SetAxis(Axis& axis, const Vector& covector, const Vector& depth, double first, double length,
    const CameraRays& rays, const Bvh& bvh)
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

  // First and last column, or row, inside the block; which there are.
  Int8 Range(const Axis& axis, const Float8 (&center)[3], const Float8& radius,
    const Float8& divisor, const Float8& least, const Int8& everywhere, std::int32_t (&first)[8],
    std::int32_t (&last)[8]) const
  {
    const Float8 x = axis.Dot(center) / divisor;
    const Float8 square = axis.Square + x * (x * axis.SquareZ - axis.Mixed);
    const Float8 size = x < 0.0f ? -x : x;
    const Float8 reach =
      (radius * Sqrt(square > 0.0f ? square : Float8{}) + axis.Error) / least * (1.0f + 1e-5f) +
      1e-6f * size + 1e-3f;
    const Float8 zero = Float8{};
    const Float8 end = zero + static_cast<float>(RayBlock::Side - 1);
    // What is not left of -1 or right of 8 keeps its value, so that conversion is defined.
    const Float8 low = x - reach;
    const Float8 high = x + reach;
    const Float8 from = everywhere ? zero
      : low > 0.0f                 ? (low < end + 1.0f ? low : end + 1.0f)
                                   : zero - 1.0f;
    const Float8 to = everywhere ? end : high < end ? (high > -1.0f ? high : zero - 1.0f) : end;
    const Int8 a = everywhere ? Int8{} : __builtin_convertvector(from + 1.0f, Int8);
    const Int8 b = __builtin_convertvector(to + 1.0f, Int8) - 1;
    Store(a, first);
    Store(b, last);
    return a <= b;
  }

  bool Parallel;
  Axis X;
  Axis Y;
  Axis Z;
};
}
}

#endif
