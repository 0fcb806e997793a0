//VTK::System::Dec

// SPDX-License-Identifier: BSD-3-Clause
// One vertex a sphere: the square of pixels that holds the sphere's whole outline.
//
// Bounds of the outline: the two tangent planes through the eye that are parallel to an axis of
// the window. Sigg, Weyrich, Botsch, Gross, "GPU-Based Ray-Casting of Quadratic Surfaces" (2006),
// section 3, has the general quadric; for a sphere each axis is a quadratic in the slope.

in vec3 centerHigh; // high and low part of the centre relative to the packing's origin
in vec3 centerLow;
in float radius;

// The sum of a high and a low part is the double that the host computed.
uniform mat3 viewHigh; // columns: the rows that take model coordinates to view coordinates
uniform mat3 viewLow;
uniform vec3 eyeHigh; // position relative to the packing's origin
uniform vec3 eyeLow;
uniform vec4 pixelMapHigh; // view slope (or position) to pixels: factors x y, offsets x y
uniform vec4 pixelMapLow;
uniform vec4 clipRange; // near, far, low parts of near, far
uniform vec4 viewport; // x, y, width, height in pixels
uniform float radiusScale;
uniform float maximumPointSize; // in pixels; larger spheres are drawn as quads,
uniform float maximumDepthShare; // and so are those that fill more than this of the depth buffer
uniform int cameraParallel;
#ifdef SPHERES_MAY_BE_HIDDEN
uniform sampler2D occluders; // the farthest depth of each tile of pixels
uniform int occluderTile; // in pixels; 0 before anything was drawn
#endif

flat out vec4 sphereReferenceVSOutput;
flat out vec4 sphereShapeVSOutput;

//VTK::Color::Dec
//VTK::Picking::Dec

// The pixels that the sphere's outline spans, exactly, and the pixel of its centre. False for a
// sphere too near to be drawn as a point.
bool findOutline(REAL3 c, REAL r, REAL2 range, out REAL2 low, out REAL2 high, out REAL2 center,
  out REAL depthShare)
{
  REAL4 map = REAL4(pixelMapHigh) + REAL4(pixelMapLow);
  if (cameraParallel != 0)
  {
    depthShare = r / (range.y - range.x);
    center = map.xy * c.xy + map.zw;
    low = center - map.xy * r;
    high = center + map.xy * r;
    return true;
  }
  REAL distance = -c.z;
  if (distance < REAL(4.0) * r)
  {
    return false;
  }
  depthShare = r * range.x * range.y / ((range.y - range.x) * distance * distance);
  REAL along = distance * distance - r * r;
  REAL2 middle = c.xy * distance;
  REAL2 spread = r * sqrt(c.xy * c.xy + along);
  center = map.xy * (c.xy / distance) + map.zw;
  low = map.xy * ((middle - spread) / along) + map.zw;
  high = map.xy * ((middle + spread) / along) + map.zw;
  return true;
}

#ifdef SPHERES_MAY_BE_HIDDEN
// Whether all that a sphere spans has been drawn already and lies before `depth`.
bool isHidden(ivec2 first, ivec2 last, float depth)
{
  if (occluderTile == 0)
  {
    return false;
  }
  ivec2 a = first / occluderTile;
  ivec2 b = last / occluderTile;
  float farthest = max(
    max(texelFetch(occluders, a, 0).r, texelFetch(occluders, ivec2(b.x, a.y), 0).r),
    max(texelFetch(occluders, ivec2(a.x, b.y), 0).r, texelFetch(occluders, b, 0).r));
  // Larger ones would have tiles between these.
  return depth > farthest && max(b.x - a.x, b.y - a.y) < 2;
}
#endif

void main()
{
  //VTK::Color::Impl
  //VTK::Picking::Impl

  // Outside the view volume: what is not drawn here.
  gl_Position = vec4(0.0, 0.0, 2.0, 1.0);
  gl_PointSize = 1.0;
  sphereReferenceVSOutput = vec4(0.0);
  sphereShapeVSOutput = vec4(0.0);

  REAL r = REAL(radius) * REAL(radiusScale);
  REAL3 p = (REAL3(centerHigh) - REAL3(eyeHigh)) + (REAL3(centerLow) - REAL3(eyeLow));
  REAL3 c = REAL3(dot(REAL3(viewHigh[0]) + REAL3(viewLow[0]), p),
    dot(REAL3(viewHigh[1]) + REAL3(viewLow[1]), p),
    dot(REAL3(viewHigh[2]) + REAL3(viewLow[2]), p));
  REAL distance = -c.z;
  REAL2 range = REAL2(clipRange.xy) + REAL2(clipRange.zw);
  if (!(r > REAL(0.0)) || distance + r < range.x || distance - r > range.y)
  {
    return;
  }

  REAL2 low;
  REAL2 high;
  REAL2 center;
  REAL depthShare; // of one radius
  if (!findOutline(c, r, range, low, high, center, depthShare))
  {
    return;
  }
  // Pixel centres inside the bounds and the viewport; the margin covers rounding.
  vec2 first = max(ceil(vec2(low) - 0.5 - 1.0e-3), vec2(0.0));
  vec2 last = min(floor(vec2(high) - 0.5 + 1.0e-3), viewport.zw - 1.0);
  vec2 count = last - first + 1.0;
  float size = max(count.x, count.y);
  if (min(count.x, count.y) < 1.0 || size > maximumPointSize ||
    depthShare > REAL(maximumDepthShare))
  {
    return;
  }

  float front = max(float(distance - r - range.x), 0.0);
  float depth = cameraParallel != 0 ? front / float(range.y - range.x)
                                    : front * float(range.y / (range.y - range.x)) /
      (front + float(range.x));
  depth *= 1.0 - 1.0e-6; // in front of every fragment, whatever the rounding
#ifdef SPHERES_MAY_BE_HIDDEN
  if (isHidden(ivec2(first), ivec2(last), depth))
  {
    return;
  }
#endif

  // Clamped, since a point whose middle is outside the viewport is dropped as a whole.
  vec2 middlePixel = min(first + 0.5 * size, viewport.zw);
  vec2 reference = floor(vec2(center)) + 0.5; // floats hold it exactly
  REAL reach = cameraParallel != 0 ? REAL(1.0) : distance;
  sphereReferenceVSOutput =
    vec4(reference + viewport.xy, vec2((REAL2(reference) - center) * reach /
      (REAL2(pixelMapHigh.xy) + REAL2(pixelMapLow.xy))));
  sphereShapeVSOutput =
    vec4(float(reach), float(r), float(distance - range.x), float(range.y - distance));
  gl_Position = vec4(2.0 * middlePixel / viewport.zw - 1.0, 2.0 * depth - 1.0, 1.0);
  gl_PointSize = size;
}
