// SPDX-License-Identifier: BSD-3-Clause
/// The rays of a camera through points of its picture, and where a sphere may be in it.
#ifndef CameraRays_h
#define CameraRays_h

#include "kernels/RaySphere.h"

#include <algorithm>

namespace spherepacking
{
using Vector = double[3];

inline double Dot(const Vector& a, const Vector& b)
{
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

inline void Cross(const Vector& a, const Vector& b, Vector& result)
{
  result[0] = a[1] * b[2] - a[2] * b[1];
  result[1] = a[2] * b[0] - a[0] * b[2];
  result[2] = a[0] * b[1] - a[1] * b[0];
}

/// x and y count pixels from the lower left corner of the picture; the middle of the first pixel is
/// at 0.5. Directions have length 1 along the viewing direction, so that t is the depth.
struct CameraRays
{
  bool Parallel; ///< if so DX and DY are 0, else OX and OY
  Vector O0;
  Vector OX;
  Vector OY;
  Vector D0;
  Vector DX;
  Vector DY;

  Ray At(double x, double y) const
  {
    Ray ray;
    for (int axis = 0; axis < 3; ++axis)
    {
      ray.O[axis] = this->O0[axis] + x * this->OX[axis] + y * this->OY[axis];
      ray.D[axis] = this->D0[axis] + x * this->DX[axis] + y * this->DY[axis];
    }
    return ray;
  }
};

/// A part of the picture.
struct ScreenBounds
{
  double X0;
  double X1;
  double Y0;
  double Y1;
};

/// Finds ScreenBounds of spheres: the inverse of the map from (x, y, depth) to points in space.
class Screen
{
public:
  explicit Screen(const CameraRays& rays)
    : Parallel(rays.Parallel)
  {
    const Vector& a = rays.Parallel ? rays.OX : rays.DX;
    const Vector& b = rays.Parallel ? rays.OY : rays.DY;
    Cross(b, rays.D0, this->X);
    Cross(rays.D0, a, this->Y);
    Cross(a, b, this->Z);
    const double determinant = Dot(this->Z, rays.D0);
    for (int axis = 0; axis < 3; ++axis)
    {
      this->O[axis] = rays.O0[axis];
      this->X[axis] /= determinant;
      this->Y[axis] /= determinant;
      this->Z[axis] /= determinant;
    }
    this->XX = Dot(this->X, this->X);
    this->YY = Dot(this->Y, this->Y);
    this->XZ = Dot(this->X, this->Z);
    this->YZ = Dot(this->Y, this->Z);
    this->ZZ = Dot(this->Z, this->Z);
    this->LengthZ = std::sqrt(this->ZZ);
  }

  /// Covector of the depth: its product with what lies `o` away from the eye.
  const Vector& Depth() const { return this->Z; }

  /// Contains every point of the picture whose ray hits the sphere; X0 > X1 when none does. In
  /// perspective the ball's points are at (p + a) / (w + b) with |a - b p/w| <= r |X - (p/w) Z|,
  /// b >= -r |Z|, so that is how far they are from the centre's picture p / w at most.
  ScreenBounds Of(const Sphere& sphere) const
  {
    const Vector f = { sphere.X - this->O[0], sphere.Y - this->O[1], sphere.Z - this->O[2] };
    const double w = Dot(this->Z, f);
    const double nearest = w - sphere.R * this->LengthZ;
    double x = Dot(this->X, f);
    double y = Dot(this->Y, f);
    double squareX = this->XX;
    double squareY = this->YY;
    double scale = sphere.R;
    if (!this->Parallel)
    {
      // What reaches the plane of the eye may be anywhere.
      if (nearest <= 1e-6 * w)
      {
        return { -Far, w + sphere.R * this->LengthZ > 0.0 ? Far : -Far - 1.0, -Far, Far };
      }
      const double inverse = 1.0 / w;
      x *= inverse;
      y *= inverse;
      squareX += x * (x * this->ZZ - 2.0 * this->XZ);
      squareY += y * (y * this->ZZ - 2.0 * this->YZ);
      scale /= nearest;
    }
    // Rounding moves the centre by parts in 10^16 of its distance and of the pictures' width.
    const double reachX = scale * std::sqrt(squareX) + Margin;
    const double reachY = scale * std::sqrt(squareY) + Margin;
    return { x - reachX, x + reachX, y - reachY, y + reachY };
  }

private:
  static constexpr double Far = 1e9;
  static constexpr double Margin = 1e-3; // pixels

  bool Parallel;
  Vector O;
  Vector X;
  Vector Y;
  Vector Z;
  double XX;
  double YY;
  double XZ;
  double YZ;
  double ZZ;
  double LengthZ;
};
}

#endif
