// SPDX-License-Identifier: BSD-3-Clause
/// The rays of a camera through points of its picture, and the projection of points to it.
#ifndef CameraRays_h
#define CameraRays_h

#include "trace/RaySphere.h"

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

/// The projection of points to the picture, the inverse of the rays: what lies f away from the eye
/// has the depth Z.f and is seen at x = X.f and y = Y.f, in perspective over the depth.
struct CameraProjection
{
  Vector X;
  Vector Y;
  Vector Z;

  explicit CameraProjection(const CameraRays& rays)
  {
    const Vector& a = rays.Parallel ? rays.OX : rays.DX;
    const Vector& b = rays.Parallel ? rays.OY : rays.DY;
    Cross(b, rays.D0, this->X);
    Cross(rays.D0, a, this->Y);
    Cross(a, b, this->Z);
    const double determinant = Dot(this->Z, rays.D0);
    for (int axis = 0; axis < 3; ++axis)
    {
      this->X[axis] /= determinant;
      this->Y[axis] /= determinant;
      this->Z[axis] /= determinant;
    }
  }
};
}

#endif
