// SPDX-License-Identifier: BSD-3-Clause
/// Sampling of directions: a cosine-weighted hemisphere, and a cone.
#ifndef Hemisphere_h
#define Hemisphere_h

#include "trace/CameraRays.h"
#include "light/OwenSobol.h"

#include <cmath>

namespace spherepacking
{
inline namespace SPHEREPACKING_ISA
{
/// Cosine and sine of 2 pi u, for u from 0 to 1, within 1e-11; the same on every processor.
inline Point2 CircleAt(double u)
{
  // Half of the angle, less half a turn: from -pi/2 to pi/2, where few terms suffice.
  const double x = 3.141592653589793 * (u - 0.5);
  const double s = x * x;
  const double sine = x *
    (1.0 -
      s * (1.0 / 6.0) *
        (1.0 -
          s * (1.0 / 20.0) *
            (1.0 -
              s * (1.0 / 42.0) *
                (1.0 -
                  s * (1.0 / 72.0) *
                    (1.0 -
                      s * (1.0 / 110.0) *
                        (1.0 - s * (1.0 / 156.0) * (1.0 - s * (1.0 / 210.0))))))));
  const double cosine = 1.0 -
    s * (1.0 / 2.0) *
      (1.0 -
        s * (1.0 / 12.0) *
          (1.0 -
            s * (1.0 / 30.0) *
              (1.0 -
                s * (1.0 / 56.0) *
                  (1.0 -
                    s * (1.0 / 90.0) *
                      (1.0 -
                        s * (1.0 / 132.0) *
                          (1.0 - s * (1.0 / 182.0) * (1.0 - s * (1.0 / 240.0))))))));
  return { 2.0 * sine * sine - 1.0, -2.0 * sine * cosine };
}

/// a x + b y + c n, where x, y and the unit vector n are perpendicular.
///
/// Source: Duff et al., "Building an Orthonormal Basis, Revisited" (2017).
inline void FromBasis(const Double3& n, double a, double b, double c, Double3& result)
{
  const double sign = std::copysign(1.0, n[2]);
  const double p = -1.0 / (sign + n[2]);
  const double q = n[0] * n[1] * p;
  result[0] = a * (1.0 + sign * n[0] * n[0] * p) + b * q + c * n[0];
  result[1] = a * sign * q + b * (sign + n[1] * n[1] * p) + c * n[1];
  result[2] = -a * sign * n[0] - b * n[1] + c * n[2];
}

/// A direction of the cosine-weighted hemisphere around n: its density is the cosine over pi.
inline void CosineDirection(const Double3& n, const Point2& u, Double3& direction)
{
  const double radius = std::sqrt(u.X);
  const Point2 circle = CircleAt(u.Y);
  FromBasis(n, radius * circle.X, radius * circle.Y, std::sqrt(1.0 - u.X), direction);
}

/// A uniform direction in a cone around n. `oneMinusCosine` is that of the angle between its axis
/// and its side, and keeps the digits of small angles.
inline void ConeDirection(
  const Double3& n, double oneMinusCosine, const Point2& u, Double3& direction)
{
  const double less = u.X * oneMinusCosine;
  const double radius = std::sqrt(less * (2.0 - less));
  const Point2 circle = CircleAt(u.Y);
  FromBasis(n, radius * circle.X, radius * circle.Y, 1.0 - less, direction);
}
}
}

#endif
