// SPDX-License-Identifier: BSD-3-Clause
#ifndef LineCrossing_h
#define LineCrossing_h

#include "base/Vector3.h"

#include <algorithm>

namespace spherepacking
{
/// Half a line, along an axis: up if `Sense` is 1, down if it is -1.
struct AxisLine
{
  Vector3 Start;
  int Axis;
  int Sense;
};

/// What is known of a half line and a triangle.
struct LineCrossing
{
  bool IsCertain;
  int Turns; ///< 1 if the line leaves through the triangle's front, -1 through its back, or 0
};

/// The sign of a sum of products that has been rounded, or 0 if rounding leaves it in doubt.
/// `magnitude` is the sum of the products' magnitudes. The factors are differences of two numbers,
/// with two factors a product for `planar` and three otherwise.
/// Source: Shewchuk, "Adaptive precision floating-point arithmetic and fast robust geometric
/// predicates" (1997), tables 2 and 3.
inline int CertainSign(double sum, double magnitude, bool planar)
{
  constexpr double half = 0x1p-53;
  const double error =
    (planar ? (3.0 + 16.0 * half) * half : (7.0 + 56.0 * half) * half) * magnitude;
  return sum > error ? 1 : -sum > error ? -1 : 0;
}

/// On which side of the plane of three corners a place lies: 1 where the normal points away.
inline int SideOf(const Vector3 (&corners)[3], const Vector3& place)
{
  const Vector3 a = corners[0] - place;
  const Vector3 b = corners[1] - place;
  const Vector3 c = corners[2] - place;
  const double bc[2] = { b.X * c.Y, c.X * b.Y };
  const double ca[2] = { c.X * a.Y, a.X * c.Y };
  const double ab[2] = { a.X * b.Y, b.X * a.Y };
  const double sum = a.Z * (bc[0] - bc[1]) + b.Z * (ca[0] - ca[1]) + c.Z * (ab[0] - ab[1]);
  const double magnitude = (std::abs(bc[0]) + std::abs(bc[1])) * std::abs(a.Z) +
    (std::abs(ca[0]) + std::abs(ca[1])) * std::abs(b.Z) +
    (std::abs(ab[0]) + std::abs(ab[1])) * std::abs(c.Z);
  return CertainSign(sum, magnitude, false);
}

/// Whether a half line goes through a triangle. That is not certain where it comes so near to an
/// edge, or starts so near to the triangle, that rounding might decide.
inline LineCrossing CrossingOf(const AxisLine& line, const Vector3 (&corners)[3])
{
  const int first = (line.Axis + 1) % 3;
  const int second = (line.Axis + 2) % 3;
  int turns = 0;
  bool certain = true;
  for (int i = 0; i < 3; ++i)
  {
    const Vector3& from = corners[i];
    const Vector3& to = corners[(i + 1) % 3];
    const double left = (from[first] - line.Start[first]) * (to[second] - line.Start[second]);
    const double right = (from[second] - line.Start[second]) * (to[first] - line.Start[first]);
    const int sign = CertainSign(left - right, std::abs(left) + std::abs(right), true);
    if (sign != 0 && sign == -turns)
    {
      return { true, 0 }; // beside the triangle, whatever the other edges say
    }
    turns = sign != 0 ? sign : turns;
    certain = certain && sign != 0;
  }
  const auto [low, high] =
    std::minmax({ corners[0][line.Axis], corners[1][line.Axis], corners[2][line.Axis] });
  const double start = line.Start[line.Axis];
  if (line.Sense > 0 ? high < start : low > start)
  {
    return { true, 0 };
  }
  if (line.Sense > 0 ? low > start : high < start)
  {
    return { certain, line.Sense * turns };
  }
  const int side = SideOf(corners, line.Start);
  const bool ahead = side == line.Sense * turns;
  return { certain && side != 0, ahead ? side : 0 };
}
}

#endif
