//VTK::System::Dec

// SPDX-License-Identifier: BSD-3-Clause
// Point sprites: one vertex per sphere becomes the square of pixels that holds the sphere's outline.
// Rejects spheres that are outside of the view volume, occluded, or to be drawn as quads.

in vec3 centerHigh; // high and low part of the centre relative to the packing's origin
in vec3 centerLow;
in float radius;

// The sum of a high and a low part is the double that the host computed.
uniform mat3 modelToViewHigh; // columns: the rows of the matrix
uniform mat3 modelToViewLow;
uniform vec3 eyeHigh; // position relative to the packing's origin
uniform vec3 eyeLow;
uniform vec4 slopeToPixelHigh; // view slopes (or view x y) to pixels: factors xy, offsets zw
uniform vec4 slopeToPixelLow;
uniform vec4 clippingRange; // near, far, low parts of near, far
uniform vec4 viewport; // x, y, width, height in pixels
uniform float radiusScale;
uniform float maximumPointSize; // in pixels; larger spheres are drawn as quads,
uniform float maximumDepthFraction; // and so are those of a larger fraction of the depth range
uniform int cameraParallel;
#ifdef HI_Z_CULLING
uniform sampler2D hiZ; // the farthest depth of each tile of pixels
uniform int hiZTileSize; // in pixels; 0 before anything has been drawn
#endif

flat out vec4 sphereReferenceVSOutput; // explained in RaySphereFS.glsl
flat out vec4 sphereShapeVSOutput;

//VTK::Color::Dec
//VTK::Picking::Dec

// The exact bounds of the projected outline, and the projected centre, in pixels. False for a sphere
// within four radii of the eye, the depths of which are differences that need double precision.
//
// In a perspective view the bounds along an axis are the slopes s of the two planes through the eye
// that touch the sphere and are parallel to the other axis. The distance of the centre, x along the
// axis and d in front of the eye, from such a plane is its radius, (x - s d)^2 = r^2 (1 + s^2), so
//
//   s = (x d -+ r sqrt(x^2 + d^2 - r^2)) / (d^2 - r^2).
//
// C. Sigg, T. Weyrich, M. Botsch, M. Gross, "GPU-Based Ray-Casting of Quadratic Surfaces" (2006),
// section 3, has such bounds for a general quadric.
bool projectBounds(REAL3 c, REAL r, REAL2 range, out REAL2 low, out REAL2 high, out REAL2 center,
  out REAL depthFraction)
{
  REAL4 slopeToPixel = REAL4(slopeToPixelHigh) + REAL4(slopeToPixelLow);
  if (cameraParallel != 0)
  {
    depthFraction = r / (range.y - range.x);
    center = slopeToPixel.xy * c.xy + slopeToPixel.zw;
    low = center - slopeToPixel.xy * r;
    high = center + slopeToPixel.xy * r;
    return true;
  }
  REAL distance = -c.z;
  if (distance < REAL(4.0) * r)
  {
    return false;
  }
  depthFraction = r * range.x * range.y / ((range.y - range.x) * distance * distance);
  REAL denominator = distance * distance - r * r;
  REAL2 middle = c.xy * distance;
  REAL2 root = r * sqrt(c.xy * c.xy + denominator);
  center = slopeToPixel.xy * (c.xy / distance) + slopeToPixel.zw;
  low = slopeToPixel.xy * ((middle - root) / denominator) + slopeToPixel.zw;
  high = slopeToPixel.xy * ((middle + root) / denominator) + slopeToPixel.zw;
  return true;
}

// The depth buffer value of the sphere's front, a step nearer than any fragment, whatever the
// rounding: the fragment shaders promise depth_greater.
float frontDepth(REAL distance, REAL r, REAL2 range)
{
  float front = max(float(distance - r - range.x), 0.0);
  float depth = cameraParallel != 0 ? front / float(range.y - range.x)
                                    : front * float(range.y / (range.y - range.x)) /
      (front + float(range.x));
  return depth * (1.0 - 1.0e-6);
}

#ifdef HI_Z_CULLING
// Whether the pixels from first to last all show something in front of `depth`.
bool isOccluded(ivec2 first, ivec2 last, float depth)
{
  if (hiZTileSize == 0)
  {
    return false;
  }
  ivec2 a = first / hiZTileSize;
  ivec2 b = last / hiZTileSize;
  float farthest = max(
    max(texelFetch(hiZ, a, 0).r, texelFetch(hiZ, ivec2(b.x, a.y), 0).r),
    max(texelFetch(hiZ, ivec2(a.x, b.y), 0).r, texelFetch(hiZ, b, 0).r));
  // Larger ones cover more tiles than these four.
  return depth > farthest && max(b.x - a.x, b.y - a.y) < 2;
}
#endif

void main()
{
  //VTK::Color::Impl
  //VTK::Picking::Impl

  // Outside of the view volume, for what is not drawn.
  gl_Position = vec4(0.0, 0.0, 2.0, 1.0);
  gl_PointSize = 1.0;
  sphereReferenceVSOutput = vec4(0.0);
  sphereShapeVSOutput = vec4(0.0);

  REAL r = REAL(radius) * REAL(radiusScale);
  REAL3 p = (REAL3(centerHigh) - REAL3(eyeHigh)) + (REAL3(centerLow) - REAL3(eyeLow));
  REAL3 c = REAL3(dot(REAL3(modelToViewHigh[0]) + REAL3(modelToViewLow[0]), p),
    dot(REAL3(modelToViewHigh[1]) + REAL3(modelToViewLow[1]), p),
    dot(REAL3(modelToViewHigh[2]) + REAL3(modelToViewLow[2]), p));
  REAL distance = -c.z;
  REAL2 range = REAL2(clippingRange.xy) + REAL2(clippingRange.zw);
  if (!(r > REAL(0.0)) || distance + r < range.x || distance - r > range.y)
  {
    return;
  }

  REAL2 low;
  REAL2 high;
  REAL2 center;
  REAL depthFraction; // of the radius
  if (!projectBounds(c, r, range, low, high, center, depthFraction))
  {
    return;
  }
  // Pixel centres inside the bounds and the viewport; the margin covers rounding.
  vec2 first = max(ceil(vec2(low) - 0.5 - 1.0e-3), vec2(0.0));
  vec2 last = min(floor(vec2(high) - 0.5 + 1.0e-3), viewport.zw - 1.0);
  vec2 count = last - first + 1.0;
  float size = max(count.x, count.y);
  if (min(count.x, count.y) < 1.0 || size > maximumPointSize ||
    depthFraction > REAL(maximumDepthFraction))
  {
    return;
  }

  float depth = frontDepth(distance, r, range);
#ifdef HI_Z_CULLING
  if (isOccluded(ivec2(first), ivec2(last), depth))
  {
    return;
  }
#endif

  // Clamped, since OpenGL clips a point as a whole if its middle is outside of the view volume
  // (OpenGL 4.6 core, section 13.7).
  vec2 middlePixel = min(first + 0.5 * size, viewport.zw);
  vec2 reference = floor(vec2(center)) + 0.5; // floats hold it exactly
  REAL reach = cameraParallel != 0 ? REAL(1.0) : distance;
  sphereReferenceVSOutput =
    vec4(reference + viewport.xy, vec2((REAL2(reference) - center) * reach /
      (REAL2(slopeToPixelHigh.xy) + REAL2(slopeToPixelLow.xy))));
  sphereShapeVSOutput =
    vec4(float(reach), float(r), float(distance - range.x), float(range.y - distance));
  gl_Position = vec4(2.0 * middlePixel / viewport.zw - 1.0, 2.0 * depth - 1.0, 1.0);
  gl_PointSize = size;
}
