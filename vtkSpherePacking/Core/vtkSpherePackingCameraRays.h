// SPDX-License-Identifier: BSD-3-Clause
// The rays of a vtkCamera. Private to the module.
#ifndef vtkSpherePackingCameraRays_h
#define vtkSpherePackingCameraRays_h

#include "kernels/CameraRays.h"

#include "vtkABINamespace.h"

VTK_ABI_NAMESPACE_BEGIN
class vtkCamera;

struct vtkSpherePackingCameraRays
{
  spherepacking::CameraRays Rays;
  spherepacking::Vector ToEye; // unit vector against the direction of view

  // False if the camera has no rays: its numbers are not finite, it stands where it looks at, looks
  // along its view-up, or sees an angle or a height of 0.
  bool Set(vtkCamera* camera, int width, int height);
};
VTK_ABI_NAMESPACE_END

#endif
