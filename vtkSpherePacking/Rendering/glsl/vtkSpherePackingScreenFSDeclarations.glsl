// SPDX-License-Identifier: BSD-3-Clause
// Lights what vtkSpherePackingSurfaceFS.glsl found: once a pixel, not once a fragment.

uniform sampler2D sphereSurfaces; // normal, depth behind the near plane
uniform sampler2D sphereDepths;
uniform sampler2D sphereColors;
uniform vec2 viewportOrigin;
uniform vec4 rayMapHigh; // as in vtkSpherePackingFSDeclarations.glsl
uniform vec3 depthMap;
