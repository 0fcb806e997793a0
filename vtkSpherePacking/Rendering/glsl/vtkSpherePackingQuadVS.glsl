//VTK::System::Dec

// SPDX-License-Identifier: BSD-3-Clause
// Corners of a quad that the host placed: spheres too near or too large for a point.

in vec3 corner; // normalised device coordinates
in vec4 sphereReference;
in vec4 sphereShape;

flat out vec4 sphereReferenceVSOutput;
flat out vec4 sphereShapeVSOutput;
//VTK::Color::Dec
//VTK::Picking::Dec

void main()
{
  //VTK::Color::Impl
  //VTK::Picking::Impl
  sphereReferenceVSOutput = sphereReference;
  sphereShapeVSOutput = sphereShape;
  gl_Position = vec4(corner, 1.0);
}
