//VTK::System::Dec

// SPDX-License-Identifier: BSD-3-Clause
// Corners of an impostor quad that the host has projected: a sphere that PointSpriteVS.glsl rejects.
// RaySphereFS.glsl explains the flat values.

in vec3 corner; // normalized device coordinates
in vec4 sphereReference;
in vec2 sphereReferenceLow;
in vec4 sphereShape;
in vec4 sphereShapeLow;
in vec2 eyePower;

flat out vec4 sphereReferenceVSOutput;
flat out vec2 sphereReferenceLowVSOutput;
flat out vec4 sphereShapeVSOutput;
flat out vec4 sphereShapeLowVSOutput;
flat out vec2 eyePowerVSOutput;
//VTK::Color::Dec
//VTK::Picking::Dec

void main()
{
  //VTK::Color::Impl
  //VTK::Picking::Impl
  sphereReferenceVSOutput = sphereReference;
  sphereReferenceLowVSOutput = sphereReferenceLow;
  sphereShapeVSOutput = sphereShape;
  sphereShapeLowVSOutput = sphereShapeLow;
  eyePowerVSOutput = eyePower;
  gl_Position = vec4(corner, 1.0);
}
