// SPDX-License-Identifier: BSD-3-Clause
// Lights what vtkSpherePackingSurfaceFS.glsl found: once a pixel, not once a fragment.

uniform usampler2D sphereSurfaces; // depth with the sign of the normal's z, colour, normal x, y
uniform vec2 viewportOrigin;
uniform vec4 rayMapHigh; // as in vtkSpherePackingFSDeclarations.glsl
uniform vec3 depthMap;

// The depth in front of the eye that a value of the depth buffer stands for.
float eyeDepth(float value)
{
  return parallelView ? depthMap.x + value * depthMap.y
                      : depthMap.x / (1.0 - value / (1.0 + depthMap.z));
}
