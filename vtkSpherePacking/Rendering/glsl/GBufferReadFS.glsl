// SPDX-License-Identifier: BSD-3-Clause
// Lighting pass of deferred shading: reads what GBufferFS.glsl wrote, for VTK's lights.

uniform usampler2D gBuffer; // texels as in GBufferFS.glsl
uniform vec2 viewportOrigin;
uniform vec4 pixelToSlopeHigh; // as in RaySphereFS.glsl
uniform vec3 depthRange;

uvec4 gBufferTexel = uvec4(0u);
float gBufferDepth = 1.0;

// Reads the texel of this fragment, or discards the fragment where there is no sphere.
void readGBuffer()
{
  gBufferTexel = texelFetch(gBuffer, ivec2(gl_FragCoord.xy - viewportOrigin), 0);
  gBufferDepth = abs(uintBitsToFloat(gBufferTexel.x));
  if (gBufferDepth >= 1.0)
  {
    discard;
  }
}

// View coordinates.
vec3 gBufferPosition()
{
  float eyeDepth = parallelView ? depthRange.x + gBufferDepth * depthRange.y
                                : depthRange.x / (1.0 - gBufferDepth / (1.0 + depthRange.z));
  return vec3(gl_FragCoord.xy * pixelToSlopeHigh.xy + pixelToSlopeHigh.zw, -1.0) *
    vec3(vec2(parallelView ? 1.0 : eyeDepth), eyeDepth);
}

vec3 gBufferNormal()
{
  vec2 xy = uintBitsToFloat(gBufferTexel.zw);
  return vec3(xy, sqrt(max(1.0 - dot(xy, xy), 0.0)) * ((gBufferTexel.x >> 31) != 0u ? -1.0 : 1.0));
}

vec4 gBufferColor()
{
  return vec4((uvec4(gBufferTexel.y) >> uvec4(0u, 8u, 16u, 24u)) & 255u) / 255.0;
}
