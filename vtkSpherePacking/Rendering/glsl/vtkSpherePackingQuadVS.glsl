//VTK::System::Dec

// SPDX-License-Identifier: BSD-3-Clause
// Corners of a quad that the host placed: spheres too near or too large for a point. The flat
// values are explained in vtkSpherePackingFSDeclarations.glsl.

in vec3 corner; // normalised device coordinates
in vec4 sphereReference;
in vec4 sphereShape;
in vec4 sphereShapeLow;
in vec4 sphereRest;

flat out vec4 sphereReferenceVSOutput;
flat out vec4 sphereShapeVSOutput;
flat out vec4 sphereShapeLowVSOutput;
flat out vec4 sphereRestVSOutput;
//VTK::Color::Dec
//VTK::Picking::Dec

void main()
{
  //VTK::Color::Impl
  //VTK::Picking::Impl
  sphereReferenceVSOutput = sphereReference;
  sphereShapeVSOutput = sphereShape;
  sphereShapeLowVSOutput = sphereShapeLow;
  sphereRestVSOutput = sphereRest;
  gl_Position = vec4(corner, 1.0);
}
