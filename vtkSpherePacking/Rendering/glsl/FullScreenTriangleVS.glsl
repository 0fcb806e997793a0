//VTK::System::Dec

// SPDX-License-Identifier: BSD-3-Clause
// One triangle that covers the viewport.

void main()
{
  gl_Position = vec4(float(4 * (gl_VertexID & 1) - 1), float(2 * (gl_VertexID & 2) - 1), -1.0, 1.0);
}
