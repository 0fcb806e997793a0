//VTK::System::Dec

// SPDX-License-Identifier: BSD-3-Clause
// Reduces a depth buffer to the farthest depth of each tile of pixels; HiZBuffer.h says what for.

//VTK::Output::Dec

uniform sampler2D depths;
uniform int tileSize; // in pixels

void main()
{
  ivec2 last = textureSize(depths, 0) - 1;
  ivec2 corner = ivec2(gl_FragCoord.xy) * tileSize;
  float farthest = 0.0;
  for (int y = 0; y < tileSize; ++y)
  {
    for (int x = 0; x < tileSize; ++x)
    {
      farthest = max(farthest, texelFetch(depths, min(corner + ivec2(x, y), last), 0).r);
    }
  }
  gl_FragData[0] = vec4(farthest);
}
