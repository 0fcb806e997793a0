// SPDX-License-Identifier: BSD-3-Clause
// The ray through a pixel centre meets a sphere, relative to that sphere's centre c.
//
// In view space the ray leaves the eye along w = (slope, -1); depths are distances in front of
// the eye. At the depth of the centre the ray passes c + (miss, 0), so a point of it is
// c + (miss, 0) + along * w, and nothing of the size of c enters: the silhouette and the hit keep
// the relative precision of the sphere itself. The discriminant is |w|^2 r^2 - |w x (miss, 0)|^2,
// which has no cancellation of large terms: Haines, Guenther, Akenine-Moller, "Precision
// Improvements for Ray/Sphere Intersection" (Ray Tracing Gems, 2019, chapter 7).
// In a parallel view w = (0, 0, -1).

// A window position and the miss of the ray through it: the miss is affine in the position.
flat in vec4 sphereReferenceVSOutput;
// Miss per unit of slope, radius, depth of the centre behind the near plane, and, for a sphere
// whose hit is near the eye, (distance to the eye)^2 - radius^2, otherwise 0.
flat in vec4 sphereShapeVSOutput;

uniform vec4 rayMap; // window position to slope (or view position): factors x y, offsets x y
uniform vec3 depthMap; // near, far - near, factor of the depth buffer's value
uniform int hitMode; // 0 the first visible hit, 1 only the near one, 2 only the far one
uniform float depthShift; // towards the viewer, in depth buffer values

float sphereBehind; // of the hit, behind the near plane
float sphereAlong;
vec2 sphereMiss;
vec2 raySlope;

// View position of the hit relative to the eye's foot point on the near plane, where z is
// precise also when the near plane is far away.
vec3 spherePosition()
{
  vec2 xy = parallelView ? gl_FragCoord.xy * rayMap.xy + rayMap.zw
                         : raySlope * (sphereBehind + depthMap.x);
  return vec3(xy, -sphereBehind);
}

#ifdef SPHERES_MAY_BE_CUT
//VTK::Clip::Dec

bool sphereHitIsVisible()
{
  if (!(sphereBehind >= 0.0 && sphereBehind <= depthMap.y))
  {
    return false;
  }
  //VTK::SpherePackingClip::Impl
  return true;
}
#endif
