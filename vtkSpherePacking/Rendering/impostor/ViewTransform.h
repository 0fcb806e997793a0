// SPDX-License-Identifier: BSD-3-Clause
#ifndef ViewTransform_h
#define ViewTransform_h

#include <array>
#include <string>
#include <vector>

class vtkAbstractMapper3D;
class vtkActor;
class vtkCamera;
class vtkMatrix4x4;
class vtkRenderer;

namespace spherepacking
{
/// The transforms from model to view to window coordinates, in double precision and relative to the
/// origin of the packing (PointSprites::GetOrigin()).
struct ViewTransform
{
  bool Parallel = false; ///< parallel projection, else perspective
  /// Model coordinates p have view coordinates ModelToView * (p - Eye).
  std::array<std::array<double, 3>, 3> ModelToView;
  std::array<double, 3> Eye;
  double RadiusScale = 1.0; ///< the uniform scale of ModelToView
  double Near = 0.0;        ///< clipping range
  double Far = 1.0;
  /// Slopes to pixels from the corner of the viewport: SlopeToPixel[i] * s_i + SlopeToPixel[i + 2]
  /// for i = 0, 1. A slope is x / depth or y / depth of a direction in view coordinates; in
  /// parallel views the view coordinate x or y is used instead.
  std::array<double, 4> SlopeToPixel;
  std::array<double, 4> Viewport; ///< x, y, width, height in pixels

  /// Takes the transforms of `actor` through the active camera of the renderer into the current GL
  /// viewport. Returns an empty string, or what prevents that: a matrix that is no similarity would
  /// make ellipsoids of spheres.
  std::string Compute(vtkRenderer* renderer, vtkActor* actor, const std::array<double, 3>& origin);

  std::array<double, 3> ToView(const std::array<double, 3>& model) const;

  /// Whether a box in data coordinates lies wholly between the near and the far plane.
  bool DepthRangeContains(const double bounds[6], const std::array<double, 3>& origin) const;

  /// The clipping planes of a mapper as coefficients for view positions whose z is relative to the
  /// near plane: hitPosition() in RaySphereFS.glsl.
  std::vector<std::array<float, 4>> ClippingPlanes(
    vtkAbstractMapper3D* mapper, vtkActor* actor, const std::array<double, 3>& origin) const;

private:
  /// ModelToView, RadiusScale and Eye, or what prevents them. The matrices are transposed, all but
  /// the actor's.
  std::string ComputeModelView(vtkMatrix4x4* worldToView, vtkMatrix4x4* actor,
    vtkMatrix4x4* projection, const std::array<double, 3>& origin);
  void ComputeClippingRange(vtkCamera* camera, vtkMatrix4x4* projection);
  void ComputeViewport(vtkRenderer* renderer, vtkMatrix4x4* projection);
  std::array<float, 4> ToNearPlaneSpace(
    const double plane[4], const std::array<double, 3>& origin) const;
};
}

#endif
