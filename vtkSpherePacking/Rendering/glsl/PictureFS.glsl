//VTK::System::Dec

// SPDX-License-Identifier: BSD-3-Clause
// Draws a picture at the depths of what it shows.

//VTK::Output::Dec

in vec2 texCoord;
uniform sampler2D colors; // not multiplied by alpha
uniform sampler2D depths; // along the direction of view, infinite where nothing is hit
uniform vec2 tileOrigin; // the part of the picture that is drawn, from 0 to 1
uniform vec2 tileSize;
uniform vec2 clippingRange;
uniform int parallelProjection;

float depthAt(ivec2 pixel, ivec2 size)
{
  return texelFetch(depths, clamp(pixel, ivec2(0), size - 1), 0).r;
}

void main()
{
  ivec2 size = textureSize(colors, 0);
  ivec2 pixel = min(ivec2((tileOrigin + texCoord * tileSize) * vec2(size)), size - 1);
  vec4 color = texelFetch(colors, pixel, 0);
  if (color.a == 0.0)
  {
    discard;
  }
  float depth = depthAt(pixel, size);
  // Where some samples of a pixel at an edge hit, but the ray through its centre does not, it takes
  // the least depth around it.
  float nearest = depth;
  for (int y = -1; y <= 1; ++y)
  {
    for (int x = -1; x <= 1; ++x)
    {
      nearest = min(nearest, depthAt(pixel + ivec2(x, y), size));
    }
  }
  depth = depth < 1e30 ? depth : nearest;
  float n = clippingRange.x;
  float f = clippingRange.y;
  float z = (depth - n) / (f - n);
  if (parallelProjection == 0)
  {
    z *= f / depth;
  }
  gl_FragDepth = clamp(z, 0.0, 1.0);
  gl_FragData[0] = color;
}
