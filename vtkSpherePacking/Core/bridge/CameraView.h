// SPDX-License-Identifier: BSD-3-Clause
#ifndef CameraView_h
#define CameraView_h

#include "trace/CameraRays.h"

class vtkCamera;

namespace spherepacking
{
/// The rays of a vtkCamera.
struct CameraView
{
  CameraRays Rays;
  Double3 ToEye; ///< unit vector against the direction of view

  /// False if the camera has no rays: its numbers are not finite, it stands where it looks at,
  /// looks along its view-up, or sees an angle or a height of 0.
  bool Set(vtkCamera* camera, int width, int height);
};
}

#endif
