// SPDX-License-Identifier: BSD-3-Clause
#include "impostor/ShaderPrograms.h"

#include "impostor/ImpostorQuads.h"
#include "impostor/SplitDouble.h"

#include "vtkShaderProgram.h"

#include "FullScreenTriangleVS.h"
#include "ImpostorQuadVS.h"
#include "PointSpriteVS.h"
#include "RaySphereFS.h"

namespace spherepacking
{
namespace
{
// Extensions have to be named before anything else. GL_ARB_gpu_shader_fp64 is core from OpenGL 4.0
// on, the others from 4.2 and 3.3 on, but VTK's shaders say #version 150.
const char* const RealTypes =
  "//VTK::System::Dec\n"
  "#extension GL_ARB_gpu_shader_fp64 : enable\n"
  "#ifdef GL_ARB_gpu_shader_fp64\n"
  "#define REAL double\n#define REAL2 dvec2\n#define REAL3 dvec3\n#define REAL4 dvec4\n"
  "#else\n"
  "#define REAL float\n#define REAL2 vec2\n#define REAL3 vec3\n#define REAL4 vec4\n"
  "#endif\n"
  "#extension GL_ARB_conservative_depth : enable\n"
  "#extension GL_ARB_shader_bit_encoding : enable\n";
}

//------------------------------------------------------------------------------
bool ShaderVariant::operator==(const ShaderVariant& other) const
{
  return this->Parallel == other.Parallel && this->Colors == other.Colors &&
    this->MayBeCut == other.MayBeCut && this->ClippingPlanes == other.ClippingPlanes;
}

//------------------------------------------------------------------------------
const char* VertexShader(ProgramKind kind)
{
  return kind == ProgramKind::PointSprites ? PointSpriteVS
    : kind == ProgramKind::Quads           ? ImpostorQuadVS
                                           : FullScreenTriangleVS;
}

//------------------------------------------------------------------------------
void AddRealTypes(std::string& source)
{
  vtkShaderProgram::Substitute(source, "//VTK::System::Dec", RealTypes);
}

//------------------------------------------------------------------------------
void AddColors(std::string& vertexShader, bool packed)
{
  vtkShaderProgram::Substitute(vertexShader, "//VTK::Color::Dec",
    packed ? "in vec4 sphereColor;\nflat out uint packedColorVSOutput;\n"
           : "in vec4 sphereColor;\nflat out vec4 sphereColorVSOutput;\n");
  vtkShaderProgram::Substitute(vertexShader, "//VTK::Color::Impl",
    packed ? "uvec4 bytes = uvec4(sphereColor * 255.0 + 0.5);\n"
             "  packedColorVSOutput = bytes.r | bytes.g << 8 | bytes.b << 16 | bytes.a << 24;\n"
           : "sphereColorVSOutput = sphereColor;\n");
}

//------------------------------------------------------------------------------
std::string RaySphereDeclarations(const ShaderVariant& variant, ProgramKind kind)
{
  // Points and quads have the depth of the sphere's front, so no fragment is nearer than the
  // rasterized depth. With that known, a driver may reject fragments before they are shaded,
  // although the shader writes depths of its own.
  std::string text = "#ifdef GL_ARB_conservative_depth\n"
                     "layout(depth_greater) out float gl_FragDepth;\n"
                     "#endif\n";
  text += kind == ProgramKind::Quads ? "#define DRAWING_QUADS\n" : "";
  text += variant.MayBeCut ? "#define SPHERES_MAY_BE_CUT\n" : "";
  text += "#define CLIPPING_PLANES " + std::to_string(variant.ClippingPlanes) + "\n";
  return text + ParallelViewDeclaration(variant.Parallel) + RaySphereFS;
}

//------------------------------------------------------------------------------
std::string ParallelViewDeclaration(bool parallel)
{
  return parallel ? "const bool parallelView = true;\n" : "const bool parallelView = false;\n";
}

//------------------------------------------------------------------------------
void SetSpriteUniforms(vtkShaderProgram* program, const ViewTransform& view, float maximumPointSize)
{
  // OpenGL's matrices are stored by columns, so a row becomes a column.
  float rows[2][9];
  float eye[2][3];
  for (int i = 0; i < 3; ++i)
  {
    SplitDouble(view.Eye[i], eye[0][i], eye[1][i]);
    for (int j = 0; j < 3; ++j)
    {
      SplitDouble(view.ModelToView[i][j], rows[0][3 * i + j], rows[1][3 * i + j]);
    }
  }
  float slopeToPixel[2][4];
  float viewport[4];
  for (int i = 0; i < 4; ++i)
  {
    SplitDouble(view.SlopeToPixel[i], slopeToPixel[0][i], slopeToPixel[1][i]);
    viewport[i] = static_cast<float>(view.Viewport[i]);
  }
  float range[4];
  SplitDouble(view.Near, range[0], range[2]);
  SplitDouble(view.Far, range[1], range[3]);
  program->SetUniformMatrix3x3("modelToViewHigh", rows[0]);
  program->SetUniformMatrix3x3("modelToViewLow", rows[1]);
  program->SetUniform3f("eyeHigh", eye[0]);
  program->SetUniform3f("eyeLow", eye[1]);
  program->SetUniform4f("slopeToPixelHigh", slopeToPixel[0]);
  program->SetUniform4f("slopeToPixelLow", slopeToPixel[1]);
  program->SetUniform4f("clippingRange", range);
  program->SetUniform4f("viewport", viewport);
  program->SetUniformf("radiusScale", static_cast<float>(view.RadiusScale));
  program->SetUniformf("maximumDepthFraction", MaximumDepthFraction);
  program->SetUniformf("maximumPointSize", maximumPointSize);
  program->SetUniformi("cameraParallel", view.Parallel ? 1 : 0);
}

//------------------------------------------------------------------------------
void SetRayUniforms(vtkShaderProgram* program, const ViewTransform& view)
{
  float pixelToSlope[2][4];
  for (int axis = 0; axis < 2; ++axis)
  {
    const double factor = 1.0 / view.SlopeToPixel[axis];
    const double offset = -(view.SlopeToPixel[2 + axis] + view.Viewport[axis]) * factor;
    SplitDouble(factor, pixelToSlope[0][axis], pixelToSlope[1][axis]);
    SplitDouble(offset, pixelToSlope[0][2 + axis], pixelToSlope[1][2 + axis]);
  }
  program->SetUniform4f("pixelToSlopeHigh", pixelToSlope[0]);
  program->SetUniform4f("pixelToSlopeLow", pixelToSlope[1]);
  const double length = view.Far - view.Near;
  const float depthRange[3] = { static_cast<float>(view.Near), static_cast<float>(length),
    static_cast<float>(view.Near / length) };
  program->SetUniform3f("depthRange", depthRange);
}
}
