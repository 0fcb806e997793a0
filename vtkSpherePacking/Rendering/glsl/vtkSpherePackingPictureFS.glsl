//VTK::System::Dec

// SPDX-License-Identifier: BSD-3-Clause
// A picture at the depths of what it shows.

//VTK::Output::Dec

in vec2 texCoord;
uniform sampler2D colors; // not multiplied by alpha
uniform sampler2D depths; // along the direction of view, infinite where nothing is hit
uniform vec2 partOrigin; // of the picture that is drawn, from 0 to 1
uniform vec2 partExtent;
uniform vec2 clippingRange;
uniform int parallelProjection;

float depthAt(ivec2 at, ivec2 size)
{
  return texelFetch(depths, clamp(at, ivec2(0), size - 1), 0).r;
}

void main()
{
  ivec2 size = textureSize(colors, 0);
  ivec2 at = min(ivec2((partOrigin + texCoord * partExtent) * vec2(size)), size - 1);
  vec4 color = texelFetch(colors, at, 0);
  if (color.a == 0.0)
  {
    discard;
  }
  float depth = depthAt(at, size);
  // At an edge that the pixel's middle misses, that of the neighbour.
  float near = depth;
  for (int y = -1; y <= 1; ++y)
  {
    for (int x = -1; x <= 1; ++x)
    {
      near = min(near, depthAt(at + ivec2(x, y), size));
    }
  }
  depth = depth < 1e30 ? depth : near;
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
