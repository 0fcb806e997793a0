//VTK::System::Dec

// SPDX-License-Identifier: BSD-3-Clause
// The farthest surface of a tile of pixels: what lies wholly behind it is hidden.
// (Greene, Kass, Miller, "Hierarchical Z-Buffer Visibility", 1993.)

//VTK::Output::Dec

uniform sampler2D sphereDepths;
uniform int occluderTile; // in pixels

void main()
{
  ivec2 last = textureSize(sphereDepths, 0) - 1;
  ivec2 corner = ivec2(gl_FragCoord.xy) * occluderTile;
  float farthest = 0.0;
  for (int y = 0; y < occluderTile; ++y)
  {
    for (int x = 0; x < occluderTile; ++x)
    {
      farthest = max(farthest, texelFetch(sphereDepths, min(corner + ivec2(x, y), last), 0).r);
    }
  }
  gl_FragData[0] = vec4(farthest);
}
