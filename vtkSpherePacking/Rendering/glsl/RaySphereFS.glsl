// SPDX-License-Identifier: BSD-3-Clause
// Where the ray through a pixel's centre meets a sphere: the test of Core/trace/RaySphere.h (the same
// formula, in single precision: see the proof there), for all fragment shaders of impostors.
//
// What differs. Everything is in view space and relative to the sphere's centre c. The ray leaves
// the eye along w = (slope, -1), so that depths in front of the eye are its parameter; in a parallel
// view w = (0, 0, -1). At the depth of c it passes c + (rayOffset, 0), so its points are
// c + (rayOffset, 0) + along * w, and nothing of the size of c enters: silhouette and hit have the
// relative precision of the sphere itself. The discriminant r^2 - |l|^2, where l is the perpendicular
// from the ray to c, is multiplied by |w|^2, which saves a division:
//
//   |w|^2 r^2 - |w x (rayOffset, 0)|^2
//
// A ray that only touches the sphere hits it. Which of both hits is seen depends on the near and far
// plane and the clipping planes instead of the ray's origin.
//
// Source: Haines, Guenther, Akenine-Moller, "Precision Improvements for Ray/Sphere Intersection"
// (Ray Tracing Gems, 2019, chapter 7).
//
// Error. An error e r^2 of the discriminant moves a hit by e r^2 / (2 sqrt(discriminant)). In one
// pixel of a thousand the root is below 0.03 r; there float's e of about 1e-7 makes 2e-6 r, which is
// two steps of a depth buffer of 24 bits once r is 5 % of its range. Spheres above that are drawn as
// quads, and quads calculate with REAL numbers: double precision where there is any.

// xy: window coordinates of a pixel, zw: the offset of the ray through it. Offsets are affine in
// window coordinates.
flat in vec4 sphereReferenceVSOutput;
// Offset per unit of slope (the distance of c, or 1 in parallel views), radius, depth of c behind the
// near plane, depth of c before the far plane.
flat in vec4 sphereShapeVSOutput;

uniform vec4 pixelToSlopeHigh; // window coordinates to slopes (or view x y): factors xy, offsets zw
uniform vec3 depthRange; // near, far - near, near / (far - near)
uniform int hitMode; // 0 the first visible hit, 1 the near one only, 2 the far one only
uniform float depthBias; // towards the viewer, in depth buffer values

#ifdef DRAWING_QUADS
uniform vec4 pixelToSlopeLow;
flat in vec2 sphereReferenceLowVSOutput; // low parts of sphereReference.zw
flat in vec4 sphereShapeLowVSOutput; // low parts of sphereShape
// Where the hit is near the eye, the power of the eye with respect to the sphere, distance^2 - r^2,
// as high and low part; otherwise 0.
flat in vec2 eyePowerVSOutput;
#else
#undef REAL
#undef REAL2
#undef REAL4
#define REAL float
#define REAL2 vec2
#define REAL4 vec4
#endif

// Results of intersectSphere(). Upstream: Mesa: its GLSL compiler warns of globals without a first
// value ("used uninitialized") where one function reads them and a later one writes them.
REAL4 sphereShape = REAL4(0.0); // both parts of the input
REAL2 raySlope = REAL2(0.0);
REAL2 rayOffset = REAL2(0.0);
REAL hitAlong = REAL(0.0); // from the depth of the centre
REAL hitBehindNear = REAL(0.0); // depth behind the near plane
REAL hitBeforeFar = REAL(0.0); // and before the far plane
float hitSide = 1.0; // 1 outside of the sphere, -1 inside

// View coordinates of the hit, but z relative to the near plane, where it is precise however far
// away that is.
vec3 hitPosition()
{
  vec2 xy = parallelView ? gl_FragCoord.xy * pixelToSlopeHigh.xy + pixelToSlopeHigh.zw
                         : vec2(raySlope) * (float(hitBehindNear) + depthRange.x);
  return vec3(xy, -float(hitBehindNear));
}

// The normal, towards the eye.
vec3 hitNormal()
{
  return (hitSide / float(sphereShape.y)) *
    (vec3(vec2(rayOffset), 0.0) + float(hitAlong) * vec3(vec2(raySlope), -1.0));
}

// The value for the depth buffer, computed from the nearer one of its ends: at the depth z in front
// of the eye, (z - n) / z f / (f - n) or 1 - (f - z) / z n / (f - n).
float hitDepth()
{
  REAL scale = REAL(1.0) /
    (parallelView ? REAL(depthRange.y) : hitBehindNear + REAL(depthRange.x));
  REAL depth = hitBehindNear * scale * (parallelView ? REAL(1.0) : REAL(1.0) + REAL(depthRange.z));
  REAL rest = hitBeforeFar * scale * (parallelView ? REAL(1.0) : REAL(depthRange.z));
  return float(depth < REAL(0.5) ? depth : REAL(1.0) - rest);
}

#ifdef SPHERES_MAY_BE_CUT
#if CLIPPING_PLANES > 0
uniform vec4 sphereClipPlanes[CLIPPING_PLANES]; // for hitPosition()
#endif

bool isHitVisible()
{
  if (!(hitBehindNear >= REAL(0.0) && hitBeforeFar >= REAL(0.0)))
  {
    return false;
  }
#if CLIPPING_PLANES > 0
  vec4 position = vec4(hitPosition(), 1.0);
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

void setHit(REAL along)
{
  hitAlong = along;
  hitBehindNear = sphereShape.z + along;
  hitBeforeFar = sphereShape.w - along;
}

// Finds the hit of the ray through this fragment, or discards the fragment.
void intersectSphere()
{
#ifdef DRAWING_QUADS
  REAL4 pixelToSlope = REAL4(pixelToSlopeHigh) + REAL4(pixelToSlopeLow);
  sphereShape = REAL4(sphereShapeVSOutput) + REAL4(sphereShapeLowVSOutput);
  rayOffset = REAL2(sphereReferenceVSOutput.zw) + REAL2(sphereReferenceLowVSOutput);
#else
  vec4 pixelToSlope = pixelToSlopeHigh;
  sphereShape = sphereShapeVSOutput;
  rayOffset = sphereReferenceVSOutput.zw;
#endif
  rayOffset +=
    REAL2(gl_FragCoord.xy - sphereReferenceVSOutput.xy) * (sphereShape.x * pixelToSlope.xy);
  raySlope =
    parallelView ? REAL2(0.0) : REAL2(gl_FragCoord.xy) * pixelToSlope.xy + pixelToSlope.zw;
  REAL rayLength2 = REAL(1.0) + dot(raySlope, raySlope);
  REAL offsetDotSlope = dot(rayOffset, raySlope);
  REAL slopeCrossOffset = raySlope.x * rayOffset.y - raySlope.y * rayOffset.x;
  REAL discriminant = rayLength2 * sphereShape.y * sphereShape.y - dot(rayOffset, rayOffset) -
    slopeCrossOffset * slopeCrossOffset;
  if (!(discriminant >= REAL(0.0)))
  {
    discard;
  }
  REAL root = sqrt(discriminant);
  REAL inverseLength2 = parallelView ? REAL(1.0) : REAL(1.0) / rayLength2;
  setHit(-(offsetDotSlope + root) * inverseLength2);
#ifdef DRAWING_QUADS
  REAL eyePower = REAL(eyePowerVSOutput.x) + REAL(eyePowerVSOutput.y);
  if (eyePower != REAL(0.0))
  {
    // Near the eye the depth of the near hit is a difference that cancels. But the distances of both
    // hits from the eye have the power of the eye as their product, and that of the far one is a sum.
    REAL depth = eyePower / (sphereShape.x * rayLength2 - offsetDotSlope + root);
    hitAlong = depth - sphereShape.x;
    hitBehindNear = depth - REAL(depthRange.x);
    hitBeforeFar = REAL(depthRange.y) - hitBehindNear;
  }
#endif
#ifdef SPHERES_MAY_BE_CUT
  if (hitMode == 2 || !isHitVisible())
  {
    if (hitMode == 1)
    {
      discard;
    }
    hitSide = -1.0;
    setHit((root - offsetDotSlope) * inverseLength2);
    if (!isHitVisible())
    {
      discard;
    }
  }
#endif
}
