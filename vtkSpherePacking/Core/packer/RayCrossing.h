// SPDX-License-Identifier: BSD-3-Clause
#ifndef RayCrossing_h
#define RayCrossing_h

#include "base/Vector3.h"

#include <algorithm>

namespace spherepacking
{
/// A ray along an axis, in its direction if `Sense` is 1 and against it if that is -1.
struct AxisRay
{
  Vector3 Origin;
  int Axis;
  int Sense;
};

/// How a ray crosses a triangle.
struct RayCrossing
{
  bool IsCertain; ///< not in doubt by rounding
  int Sign;       ///< 1 where the ray leaves through the front, -1 through the back, 0 if it misses
};

/// The floating-point filter of a geometric predicate: the sign of a rounded sum of products, or 0
/// if its error may be larger. `magnitude` is the sum of the products' magnitudes. The factors are
/// differences of two numbers, two per product for `planar` and three otherwise.
/// Source: Shewchuk, "Adaptive precision floating-point arithmetic and fast robust geometric
/// predicates" (1997), tables 2 and 3.
inline int CertainSign(double sum, double magnitude, bool planar)
{
  constexpr double half = 0x1p-53;
  const double error =
    (planar ? (3.0 + 16.0 * half) * half : (7.0 + 56.0 * half) * half) * magnitude;
  return sum > error ? 1 : -sum > error ? -1 : 0;
}

/// Shewchuk's orient3d: on which side of the plane through three corners a point lies, 1 on the one
/// that the normal points away from, -1 on the other, 0 if that is in doubt.
inline int Orient3D(const Vector3 (&corners)[3], const Vector3& point)
{
  const Vector3 a = corners[0] - point;
  const Vector3 b = corners[1] - point;
  const Vector3 c = corners[2] - point;
  const double bc[2] = { b.X * c.Y, c.X * b.Y };
  const double ca[2] = { c.X * a.Y, a.X * c.Y };
  const double ab[2] = { a.X * b.Y, b.X * a.Y };
  const double sum = a.Z * (bc[0] - bc[1]) + b.Z * (ca[0] - ca[1]) + c.Z * (ab[0] - ab[1]);
  const double magnitude = (std::abs(bc[0]) + std::abs(bc[1])) * std::abs(a.Z) +
    (std::abs(ca[0]) + std::abs(ca[1])) * std::abs(b.Z) +
    (std::abs(ab[0]) + std::abs(ab[1])) * std::abs(c.Z);
  return CertainSign(sum, magnitude, false);
}

/// Intersects a ray with a triangle: the ray's origin against each edge, projected along the axis
/// (Shewchuk's orient2d), then, if the triangle spans the origin along the axis, against its plane.
/// In doubt where the ray passes too near to an edge, or begins too near to the triangle.
inline RayCrossing Intersect(const AxisRay& ray, const Vector3 (&corners)[3])
{
  const int first = (ray.Axis + 1) % 3;
  const int second = (ray.Axis + 2) % 3;
  int orientation = 0;
  bool certain = true;
  for (int i = 0; i < 3; ++i)
  {
    const Vector3& from = corners[i];
    const Vector3& to = corners[(i + 1) % 3];
    const double left = (from[first] - ray.Origin[first]) * (to[second] - ray.Origin[second]);
    const double right = (from[second] - ray.Origin[second]) * (to[first] - ray.Origin[first]);
    const int sign = CertainSign(left - right, std::abs(left) + std::abs(right), true);
    if (sign != 0 && sign == -orientation)
    {
      return { true, 0 }; // a miss, whatever the other edges say
    }
    orientation = sign != 0 ? sign : orientation;
    certain = certain && sign != 0;
  }
  const auto [low, high] =
    std::minmax({ corners[0][ray.Axis], corners[1][ray.Axis], corners[2][ray.Axis] });
  const double origin = ray.Origin[ray.Axis];
  if (ray.Sense > 0 ? high < origin : low > origin)
  {
    return { true, 0 };
  }
  if (ray.Sense > 0 ? low > origin : high < origin)
  {
    return { certain, ray.Sense * orientation };
  }
  const int side = Orient3D(corners, ray.Origin);
  const bool ahead = side == ray.Sense * orientation;
  return { certain && side != 0, ahead ? side : 0 };
}
}

#endif
