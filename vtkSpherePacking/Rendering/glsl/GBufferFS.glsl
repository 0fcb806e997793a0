//VTK::System::Dec

// SPDX-License-Identifier: BSD-3-Clause
// Geometry pass of deferred shading: writes a texel of the G-buffer, which GBufferReadFS.glsl reads.
// Every fragment of a packing is shaded by this, of which one in ten may be visible.

// x: depth buffer value, with the sign of the normal's z; y: colour as RGBA bytes, lowest first;
// zw: x and y of the normal.
out uvec4 gBufferTexel;
#ifdef SPHERES_HAVE_COLORS
flat in uint packedColorVSOutput;
#endif
//SpherePacking::RaySphere::Dec

void main()
{
  intersectSphere();
  gl_FragDepth = hitDepth();
  vec3 normal = hitNormal();
#ifdef SPHERES_HAVE_COLORS
  uint color = packedColorVSOutput;
#else
  uint color = 0u;
#endif
  gBufferTexel = uvec4(floatBitsToUint(normal.z < 0.0 ? -gl_FragDepth : gl_FragDepth), color,
    floatBitsToUint(normal.x), floatBitsToUint(normal.y));
}
