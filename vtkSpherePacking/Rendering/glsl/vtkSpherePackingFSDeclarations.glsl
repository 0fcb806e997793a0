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
//
// An error e r^2 of the discriminant moves a hit by e r^2 / (2 sqrt(discriminant)). On one pixel in
// a thousand the root is below 0.03 r; there the float's e of about 1e-7 makes 2e-6 r, which is
// two steps of a buffer of 24 bits once r is 5 % of its range. Such spheres are drawn as quads,
// and quads calculate with REAL numbers.

// A window position and the miss of the ray through it: the miss is affine in the position.
flat in vec4 sphereReferenceVSOutput;
// Miss per unit of slope, radius, depth of the centre behind the near plane and before the far.
flat in vec4 sphereShapeVSOutput;

uniform vec4 rayMapHigh; // window position to slope (or view position): factors x y, offsets x y
uniform vec3 depthMap; // near, far - near, near / (far - near)
uniform int hitMode; // 0 the first visible hit, 1 only the near one, 2 only the far one
uniform float depthShift; // towards the viewer, in depth buffer values

#ifdef DRAWING_QUADS
uniform vec4 rayMapLow;
flat in vec4 sphereShapeLowVSOutput; // low parts of the shape
// Low parts of the reference's miss; (distance to the eye)^2 - radius^2 as high and low part where
// the hit is near the eye, otherwise 0.
flat in vec4 sphereRestVSOutput;
#else
#undef REAL
#undef REAL2
#undef REAL4
#define REAL float
#define REAL2 vec2
#define REAL4 vec4
#endif

// Set to something, since some compilers warn of what functions read from globals.
REAL sphereBehind = REAL(0.0); // of the hit, behind the near plane
REAL sphereBefore = REAL(0.0); // and before the far plane
REAL sphereAlong = REAL(0.0);
REAL2 sphereMiss = REAL2(0.0);
REAL2 raySlope = REAL2(0.0);
REAL4 sphereShape = REAL4(0.0);

// View position of the hit relative to the eye's foot point on the near plane, where z is
// precise also when the near plane is far away.
vec3 spherePosition()
{
  vec2 xy = parallelView ? gl_FragCoord.xy * rayMapHigh.xy + rayMapHigh.zw
                         : vec2(raySlope) * (float(sphereBehind) + depthMap.x);
  return vec3(xy, -float(sphereBehind));
}

// The value that the depth buffer stores, from the nearer one of its ends.
float sphereDepth()
{
  REAL scale = REAL(1.0) /
    (parallelView ? REAL(depthMap.y) : sphereBehind + REAL(depthMap.x));
  REAL depth = sphereBehind * scale * (parallelView ? REAL(1.0) : REAL(1.0) + REAL(depthMap.z));
  REAL rest = sphereBefore * scale * (parallelView ? REAL(1.0) : REAL(depthMap.z));
  return float(depth < REAL(0.5) ? depth : REAL(1.0) - rest);
}

#ifdef SPHERES_MAY_BE_CUT
#if CLIPPING_PLANES > 0
uniform vec4 sphereClipPlanes[CLIPPING_PLANES];
#endif

bool sphereHitIsVisible()
{
  if (!(sphereBehind >= REAL(0.0) && sphereBefore >= REAL(0.0)))
  {
    return false;
  }
#if CLIPPING_PLANES > 0
  vec4 position = vec4(spherePosition(), 1.0);
  for (int i = 0; i < CLIPPING_PLANES; ++i)
  {
    if (dot(sphereClipPlanes[i], position) < 0.0)
    {
      return false;
    }
  }
#endif
  return true;
}
#endif

void sphereMoveTo(REAL along)
{
  sphereAlong = along;
  sphereBehind = sphereShape.z + along;
  sphereBefore = sphereShape.w - along;
}
