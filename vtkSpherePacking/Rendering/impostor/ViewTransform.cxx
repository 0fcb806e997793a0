// SPDX-License-Identifier: BSD-3-Clause
#include "impostor/ViewTransform.h"

#include "vtkAbstractMapper3D.h"
#include "vtkActor.h"
#include "vtkCamera.h"
#include "vtkMath.h"
#include "vtkMatrix3x3.h"
#include "vtkMatrix4x4.h"
#include "vtkOpenGLCamera.h"
#include "vtkOpenGLRenderWindow.h"
#include "vtkOpenGLState.h"
#include "vtkRenderer.h"
#include "vtk_glad.h"

#include <algorithm>
#include <cmath>

namespace spherepacking
{
namespace
{
// The uniform scale of a similarity, or 0 if the matrix stretches or shears.
double SimilarityScale(const std::array<std::array<double, 3>, 3>& rows)
{
  const double squared = vtkMath::Dot(rows[0].data(), rows[0].data());
  for (int i = 0; i < 3; ++i)
  {
    for (int j = i; j < 3; ++j)
    {
      const double expected = i == j ? squared : 0.0;
      if (std::abs(vtkMath::Dot(rows[i].data(), rows[j].data()) - expected) > 1e-6 * squared)
      {
        return 0.0;
      }
    }
  }
  return std::sqrt(squared);
}
}

//------------------------------------------------------------------------------
std::string ViewTransform::Compute(
  vtkRenderer* renderer, vtkActor* actor, const std::array<double, 3>& origin)
{
  auto* camera = static_cast<vtkOpenGLCamera*>(renderer->GetActiveCamera());
  // These matrices are transposed.
  vtkMatrix4x4* worldToView;
  vtkMatrix3x3* normals;
  vtkMatrix4x4* projection;
  vtkMatrix4x4* worldToDevice;
  camera->GetKeyMatrices(renderer, worldToView, normals, projection, worldToDevice);
  this->Parallel = camera->GetParallelProjection() != 0;
  if (this->Parallel &&
    (projection->GetElement(2, 0) != 0.0 || projection->GetElement(2, 1) != 0.0))
  {
    return "the parallel view is sheared, as by stereo or a view shear; spheres allow that in "
           "perspective only";
  }
  std::string problem = this->ComputeModelView(worldToView, actor->GetMatrix(), projection, origin);
  if (problem.empty())
  {
    this->ComputeClippingRange(camera, projection);
    this->ComputeViewport(renderer, projection);
  }
  return problem;
}

//------------------------------------------------------------------------------
std::string ViewTransform::ComputeModelView(vtkMatrix4x4* worldToView, vtkMatrix4x4* actor,
  vtkMatrix4x4* projection, const std::array<double, 3>& origin)
{
  double view[16];
  double modelToView[16];
  vtkMatrix4x4::Transpose(worldToView->GetData(), view);
  vtkMatrix4x4::Multiply4x4(view, actor->GetData(), modelToView);
  std::array<double, 3> shift;
  for (int i = 0; i < 3; ++i)
  {
    const double* row = modelToView + 4 * i;
    this->ModelToView[i] = { row[0], row[1], row[2] };
    shift[i] = row[3] + vtkMath::Dot(row, origin.data());
  }
  this->RadiusScale = SimilarityScale(this->ModelToView);
  if (!(this->RadiusScale > 0.0))
  {
    const double cameraScale = SimilarityScale({ { { view[0], view[1], view[2] },
      { view[4], view[5], view[6] }, { view[8], view[9], view[10] } } });
    return cameraScale > 0.0
      ? "the actor's matrix stretches, shears or flattens; spheres allow rotation, translation and "
        "uniform scale"
      : "the camera's view transform stretches, shears or flattens, as when its position is its "
        "focal point; spheres allow rotation, translation and uniform scale";
  }
  for (int i = 0; i < 2 && !this->Parallel; ++i)
  {
    // Stereo and view shear move the eye sideways within the projection.
    shift[i] += projection->GetElement(3, i) / projection->GetElement(i, i);
  }
  // The inverse of a similarity is its transpose divided by the square of its scale.
  const double squared = this->RadiusScale * this->RadiusScale;
  for (int j = 0; j < 3; ++j)
  {
    this->Eye[j] = -(this->ModelToView[0][j] * shift[0] + this->ModelToView[1][j] * shift[1] +
                     this->ModelToView[2][j] * shift[2]) /
      squared;
  }
  return {};
}

//------------------------------------------------------------------------------
void ViewTransform::ComputeClippingRange(vtkCamera* camera, vtkMatrix4x4* projection)
{
  // An explicit projection matrix goes by its own near and far plane, whatever the camera says.
  const double p22 = projection->GetElement(2, 2);
  const double p23 = projection->GetElement(3, 2);
  if (!camera->GetUseExplicitProjectionTransformMatrix())
  {
    camera->GetClippingRange(this->Near, this->Far);
  }
  else if (this->Parallel)
  {
    this->Near = (p23 + 1.0) / p22;
    this->Far = (p23 - 1.0) / p22;
  }
  else
  {
    this->Near = p23 / (p22 - 1.0);
    this->Far = p23 / (p22 + 1.0);
  }
}

//------------------------------------------------------------------------------
void ViewTransform::ComputeViewport(vtkRenderer* renderer, vtkMatrix4x4* projection)
{
  int viewport[4];
  static_cast<vtkOpenGLRenderWindow*>(renderer->GetRenderWindow())
    ->GetState()
    ->vtkglGetIntegerv(GL_VIEWPORT, viewport);
  std::copy_n(viewport, 4, this->Viewport.begin());
  for (int i = 0; i < 2; ++i)
  {
    const double half = 0.5 * this->Viewport[2 + i];
    const double offset =
      this->Parallel ? projection->GetElement(3, i) : -projection->GetElement(2, i);
    this->SlopeToPixel[i] = half * projection->GetElement(i, i);
    this->SlopeToPixel[2 + i] = half * (1.0 + offset);
  }
}

//------------------------------------------------------------------------------
std::array<double, 3> ViewTransform::ToView(const std::array<double, 3>& model) const
{
  const double p[3] = { model[0] - this->Eye[0], model[1] - this->Eye[1], model[2] - this->Eye[2] };
  return { vtkMath::Dot(this->ModelToView[0].data(), p),
    vtkMath::Dot(this->ModelToView[1].data(), p), vtkMath::Dot(this->ModelToView[2].data(), p) };
}

//------------------------------------------------------------------------------
bool ViewTransform::DepthRangeContains(
  const double bounds[6], const std::array<double, 3>& origin) const
{
  for (int corner = 0; corner < 8; ++corner)
  {
    std::array<double, 3> model;
    for (int axis = 0; axis < 3; ++axis)
    {
      model[axis] = bounds[2 * axis + ((corner >> axis) & 1)] - origin[axis];
    }
    const double depth = -this->ToView(model)[2];
    if (!(depth >= this->Near && depth <= this->Far))
    {
      return false;
    }
  }
  return true;
}

//------------------------------------------------------------------------------
std::vector<std::array<float, 4>> ViewTransform::ClippingPlanes(
  vtkAbstractMapper3D* mapper, vtkActor* actor, const std::array<double, 3>& origin) const
{
  std::vector<std::array<float, 4>> planes(mapper->GetNumberOfClippingPlanes());
  for (std::size_t i = 0; i < planes.size(); ++i)
  {
    double plane[4]; // a x + b y + c z + d in data coordinates
    mapper->GetClippingPlaneInDataCoords(actor->GetMatrix(), static_cast<int>(i), plane);
    planes[i] = this->ToNearPlaneSpace(plane, origin);
  }
  return planes;
}

//------------------------------------------------------------------------------
std::array<float, 4> ViewTransform::ToNearPlaneSpace(
  const double plane[4], const std::array<double, 3>& origin) const
{
  const double squared = this->RadiusScale * this->RadiusScale;
  double normal[3];
  double constant = plane[3];
  for (int i = 0; i < 3; ++i)
  {
    normal[i] = vtkMath::Dot(this->ModelToView[i].data(), plane) / squared;
    constant += plane[i] * (origin[i] + this->Eye[i]);
  }
  constant -= normal[2] * this->Near;
  return { static_cast<float>(normal[0]), static_cast<float>(normal[1]),
    static_cast<float>(normal[2]), static_cast<float>(constant) };
}
}
