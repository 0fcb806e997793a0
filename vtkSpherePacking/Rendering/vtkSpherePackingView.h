// SPDX-License-Identifier: BSD-3-Clause
// What the shaders need to know about the camera, in double precision and relative to the
// packing's origin. Private to the module.
#ifndef vtkSpherePackingView_h
#define vtkSpherePackingView_h

#include "vtkABINamespace.h"

#include <array>
#include <string>

VTK_ABI_NAMESPACE_BEGIN
class vtkActor;
class vtkCamera;
class vtkMatrix4x4;
class vtkRenderer;

struct vtkSpherePackingView
{
  bool Parallel = false;
  // Model coordinates p (relative to the origin) have view coordinates Rows * (p - Eye).
  std::array<std::array<double, 3>, 3> Rows;
  std::array<double, 3> Eye;
  double RadiusScale = 1.0;
  double Near = 0.0;
  double Far = 1.0;
  // Pixels from the viewport's corner: PixelMap[i] * v_i + PixelMap[i + 2] with i = 0, 1, where v
  // is the slope x / depth, y / depth of a direction, in parallel views the view position x, y.
  std::array<double, 4> PixelMap;
  // x, y, width, height in pixels.
  std::array<double, 4> Viewport;

  // The view of `actor` through the renderer's active camera into the current GL viewport. Returns
  // an empty string, or why there is no such view: a matrix that is no similarity would make
  // ellipsoids of spheres.
  std::string Compute(vtkRenderer* renderer, vtkActor* actor, const std::array<double, 3>& origin);

  std::array<double, 3> ToView(const std::array<double, 3>& model) const;

  // Whether all of a box of data coordinates lies between the near and the far plane.
  bool HoldsDepthsOf(const double bounds[6], const std::array<double, 3>& origin) const;

  // Pixels along a side of a square about as large as a sphere of that radius in the middle of a
  // box of data coordinates, a power of two from 4 to 32.
  int ChooseTile(const double bounds[6], const std::array<double, 3>& origin, double radius) const;

  // The plane a x + b y + c z + d of data coordinates as coefficients for positions whose z is
  // relative to the near plane (see vtkSpherePackingFSDeclarations.glsl).
  std::array<float, 4> ToNearPlaneSpace(
    const double plane[4], const std::array<double, 3>& origin) const;

private:
  // Rows, RadiusScale and Eye, or why there are none. Transposed matrices, but the actor's.
  std::string ComputeEye(vtkMatrix4x4* worldToView, vtkMatrix4x4* actor, vtkMatrix4x4* projection,
    const std::array<double, 3>& origin);
  void ComputeRange(vtkCamera* camera, vtkMatrix4x4* projection);
  void ComputePixels(vtkRenderer* renderer, vtkMatrix4x4* projection);
};
VTK_ABI_NAMESPACE_END

#endif
