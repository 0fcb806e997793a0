// SPDX-License-Identifier: BSD-3-Clause
/// The rays of a camera through points of its picture, and the projection of points to it.
#ifndef CameraRays_h
#define CameraRays_h

#include "base/Vector3.h"
#include "trace/RaySphere.h"

namespace spherepacking
{
/// x and y count pixels from the lower left corner of the picture; the middle of the first pixel is
/// at 0.5. Directions have length 1 along the viewing direction, so that t is the depth.
struct CameraRays
{
  bool Parallel; ///< if so DX and DY are 0, else OX and OY
  Double3 O0;
  Double3 OX;
  Double3 OY;
  Double3 D0;
  Double3 DX;
  Double3 DY;

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
  Double3 X;
  Double3 Y;
  Double3 Z;

  explicit CameraProjection(const CameraRays& rays)
  {
    const Double3& a = rays.Parallel ? rays.OX : rays.DX;
    const Double3& b = rays.Parallel ? rays.OY : rays.DY;
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
