//VTK::System::Dec

// SPDX-License-Identifier: BSD-3-Clause
// What is seen in a pixel, for vtkSpherePackingScreenFSDeclarations.glsl to light: every fragment
// of a packing comes through here, and of ten only one may remain.

out uvec4 sphereSurface; // depth with the sign of the normal's z, colour, normal's x and y
#ifdef SPHERES_HAVE_COLORS
flat in uint packedColorVSOutput;
#endif
//VTK::SpherePacking::Dec

void main()
{
//VTK::SpherePacking::Impl
  gl_FragDepth = sphereDepth();
  vec3 normal = (sphereSide / float(sphereShape.y)) *
    (vec3(vec2(sphereMiss), 0.0) + float(sphereAlong) * vec3(vec2(raySlope), -1.0));
#ifdef SPHERES_HAVE_COLORS
  uint color = packedColorVSOutput;
#else
  uint color = 0u;
#endif
  sphereSurface = uvec4(floatBitsToUint(normal.z < 0.0 ? -gl_FragDepth : gl_FragDepth), color,
    floatBitsToUint(normal.x), floatBitsToUint(normal.y));
}
