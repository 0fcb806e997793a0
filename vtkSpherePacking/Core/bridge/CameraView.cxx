// SPDX-License-Identifier: BSD-3-Clause
#include "bridge/CameraView.h"

#include "vtkCamera.h"
#include "vtkMatrix4x4.h"
#include "vtkNew.h"

#include <cmath>

namespace spherepacking
{
namespace
{

// Device coordinates (x, y) w = A (vx, vy) + b vz + c, where w is -vz in perspective, else 1.
// Solves for (vx, vy) as a linear function of (x, y, 1) and of the depth -vz.
struct ViewRays
{
  double Origin[3][2];    // for x, y and 1
  double Direction[3][2]; // the same, for a step of 1 in depth

  bool Set(const vtkMatrix4x4* projection, bool parallel)
  {
    const auto p = [&](int row, int column) { return projection->GetElement(row, column); };
    const double determinant = p(0, 0) * p(1, 1) - p(0, 1) * p(1, 0);
    const double inverse[2][2] = { { p(1, 1) / determinant, -p(0, 1) / determinant },
      { -p(1, 0) / determinant, p(0, 0) / determinant } };
    for (int i = 0; i < 2; ++i)
    {
      const double a[2] = { inverse[i][0], inverse[i][1] };
      const double slope = a[0] * p(0, 2) + a[1] * p(1, 2);
      const double offset = -(a[0] * p(0, 3) + a[1] * p(1, 3));
      for (int k = 0; k < 2; ++k)
      {
        this->Origin[k][i] = parallel ? a[k] : 0.0;
        this->Direction[k][i] = parallel ? 0.0 : a[k];
      }
      this->Origin[2][i] = offset;
      this->Direction[2][i] = slope;
    }
    return std::isfinite(1.0 / determinant);
  }
};

// World space = M (vx, vy, -depth, 1).
void ToWorld(
  const vtkMatrix4x4* matrix, const double (&xy)[2], double depth, double one, Double3& result)
{
  for (int axis = 0; axis < 3; ++axis)
  {
    result[axis] = matrix->GetElement(axis, 0) * xy[0] + matrix->GetElement(axis, 1) * xy[1] -
      matrix->GetElement(axis, 2) * depth + matrix->GetElement(axis, 3) * one;
  }
}
}

//------------------------------------------------------------------------------
bool CameraView::Set(vtkCamera* camera, int width, int height)
{
  const bool parallel = camera->GetParallelProjection() != 0;
  const double aspect = static_cast<double>(width) / height;
  ViewRays view;
  const bool projects = view.Set(camera->GetProjectionTransformMatrix(aspect, -1.0, 1.0), parallel);
  vtkMatrix4x4* toView = camera->GetModelViewTransformMatrix();
  // Not finite, or without a direction for the picture's upper side.
  if (!(std::abs(toView->Determinant()) > 0.0))
  {
    return false;
  }
  vtkNew<vtkMatrix4x4> toWorld;
  vtkMatrix4x4::Invert(toView, toWorld);

  // From pixels to device coordinates: x = 2 px / width - 1.
  const double scale[2] = { 2.0 / width, 2.0 / height };
  double origin[3][2];
  double direction[3][2];
  for (int i = 0; i < 2; ++i)
  {
    for (int k = 0; k < 2; ++k)
    {
      origin[k][i] = view.Origin[k][i] * scale[k];
      direction[k][i] = view.Direction[k][i] * scale[k];
    }
    origin[2][i] = view.Origin[2][i] - view.Origin[0][i] - view.Origin[1][i];
    direction[2][i] = view.Direction[2][i] - view.Direction[0][i] - view.Direction[1][i];
  }
  CameraRays& rays = this->Rays;
  rays.Parallel = parallel;
  ToWorld(toWorld, origin[0], 0.0, 0.0, rays.OX);
  ToWorld(toWorld, origin[1], 0.0, 0.0, rays.OY);
  ToWorld(toWorld, origin[2], 0.0, 1.0, rays.O0);
  ToWorld(toWorld, direction[0], 0.0, 0.0, rays.DX);
  ToWorld(toWorld, direction[1], 0.0, 0.0, rays.DY);
  ToWorld(toWorld, direction[2], 1.0, 0.0, rays.D0);

  const double nowhere[2] = { 0.0, 0.0 };
  ToWorld(toWorld, nowhere, -1.0, 0.0, this->ToEye);
  const double length = std::sqrt(Dot(this->ToEye, this->ToEye));
  bool finite = projects && length > 0.0;
  for (int axis = 0; axis < 3; ++axis)
  {
    this->ToEye[axis] /= length;
    finite = finite &&
      std::isfinite(rays.O0[axis] + rays.OX[axis] + rays.OY[axis] + rays.D0[axis] + rays.DX[axis] +
        rays.DY[axis]);
  }
  // Three directions that span space.
  Double3 normal;
  Cross(parallel ? rays.OX : rays.DX, parallel ? rays.OY : rays.DY, normal);
  return finite && std::abs(Dot(normal, rays.D0)) > 0.0;
}
}
