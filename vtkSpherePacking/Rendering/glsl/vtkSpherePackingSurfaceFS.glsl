//VTK::System::Dec

// SPDX-License-Identifier: BSD-3-Clause
// What is seen in a pixel, for vtkSpherePackingScreenFSDeclarations.glsl to light: every fragment
// of a packing comes through here, and of ten only one may remain.

//VTK::Output::Dec
//VTK::SpherePacking::Dec

void main()
{
//VTK::SpherePacking::Impl
  gl_FragDepth = sphereDepth();
  vec3 normal = (sphereSide / float(sphereShape.y)) *
    (vec3(vec2(sphereMiss), 0.0) + float(sphereAlong) * vec3(vec2(raySlope), -1.0));
  gl_FragData[0] = vec4(normal, float(sphereBehind));
#ifdef SPHERES_HAVE_COLORS
  gl_FragData[1] = sphereColorVSOutput;
#endif
}
