// SPDX-License-Identifier: BSD-3-Clause
#include "vtkSpherePackingPrograms.h"

#include "vtkOpenGLBufferObject.h"
#include "vtkOpenGLVertexArrayObject.h"
#include "vtkShaderProgram.h"
#include "vtkSpherePackingQuads.h"
#include "vtkSpherePackingSplit.h"
#include "vtkSpherePackingVertices.h"

#include "vtkSpherePackingFSDeclarations.h"

#include <cstddef>

VTK_ABI_NAMESPACE_BEGIN
namespace
{
// Adds the attributes of one interleaved buffer that the program uses.
struct AttributeAdder
{
  vtkOpenGLVertexArrayObject* Vao;
  vtkShaderProgram* Program;
  vtkOpenGLBufferObject* Buffer;
  std::size_t Stride;

  void Floats(const char* name, std::size_t offset, int components) const
  {
    this->Add(name, offset, VTK_FLOAT, components, false);
  }
  void Bytes(const char* name, std::size_t offset, bool normalize) const
  {
    this->Add(name, offset, VTK_UNSIGNED_CHAR, 4, normalize);
  }

private:
  void Add(const char* name, std::size_t offset, int type, int components, bool normalize) const
  {
    if (this->Program->IsAttributeUsed(name))
    {
      this->Vao->AddAttributeArray(this->Program, this->Buffer, name, static_cast<int>(offset),
        this->Stride, type, components, normalize);
    }
  }
};
}

//------------------------------------------------------------------------------
const char* const vtkSpherePackingRealTypes =
  "//VTK::System::Dec\n"
  "#extension GL_ARB_gpu_shader_fp64 : enable\n"
  "#ifdef GL_ARB_gpu_shader_fp64\n"
  "#define REAL double\n#define REAL2 dvec2\n#define REAL3 dvec3\n#define REAL4 dvec4\n"
  "#else\n"
  "#define REAL float\n#define REAL2 vec2\n#define REAL3 vec3\n#define REAL4 vec4\n"
  "#endif\n"
  "#extension GL_ARB_conservative_depth : enable\n"
  "#extension GL_ARB_shader_bit_encoding : enable\n";

//------------------------------------------------------------------------------
bool vtkSpherePackingFeatures::operator==(const vtkSpherePackingFeatures& other) const
{
  return this->Quads == other.Quads && this->Parallel == other.Parallel &&
    this->Colors == other.Colors && this->MayBeCut == other.MayBeCut &&
    this->ClippingPlanes == other.ClippingPlanes;
}

//------------------------------------------------------------------------------
std::string vtkSpherePackingHitDeclarations(const vtkSpherePackingFeatures& features)
{
  std::string text;
  // The rasterised depth is that of the sphere's front, so early depth tests may reject.
  text += "#ifdef GL_ARB_conservative_depth\n"
          "layout(depth_greater) out float gl_FragDepth;\n"
          "#endif\n";
  text += features.Quads ? "#define DRAWING_QUADS\n" : "";
  text += features.MayBeCut ? "#define SPHERES_MAY_BE_CUT\n" : "";
  text += "#define CLIPPING_PLANES " + std::to_string(features.ClippingPlanes) + "\n";
  text +=
    features.Parallel ? "const bool parallelView = true;\n" : "const bool parallelView = false;\n";
  return text + vtkSpherePackingFSDeclarations;
}

//------------------------------------------------------------------------------
std::string vtkSpherePackingWithColors(std::string vertexShader, bool packed)
{
  vtkShaderProgram::Substitute(vertexShader, "//VTK::Color::Dec",
    packed ? "in vec4 sphereColor;\nflat out uint packedColorVSOutput;\n"
           : "in vec4 sphereColor;\nflat out vec4 sphereColorVSOutput;\n");
  vtkShaderProgram::Substitute(vertexShader, "//VTK::Color::Impl",
    packed ? "uvec4 bytes = uvec4(sphereColor * 255.0 + 0.5);\n"
             "  packedColorVSOutput = bytes.r | bytes.g << 8 | bytes.b << 16 | bytes.a << 24;\n"
           : "sphereColorVSOutput = sphereColor;\n");
  return vertexShader;
}

//------------------------------------------------------------------------------
void vtkSpherePackingSetPointUniforms(
  vtkShaderProgram* program, const vtkSpherePackingView& view, float maximumPointSize)
{
  // Matrices go column by column, so a row becomes a column.
  float rows[2][9];
  float eye[2][3];
  for (int i = 0; i < 3; ++i)
  {
    vtkSpherePackingSplit(view.Eye[i], eye[0][i], eye[1][i]);
    for (int j = 0; j < 3; ++j)
    {
      vtkSpherePackingSplit(view.Rows[i][j], rows[0][3 * i + j], rows[1][3 * i + j]);
    }
  }
  float pixelMap[2][4];
  float viewport[4];
  for (int i = 0; i < 4; ++i)
  {
    vtkSpherePackingSplit(view.PixelMap[i], pixelMap[0][i], pixelMap[1][i]);
    viewport[i] = static_cast<float>(view.Viewport[i]);
  }
  float range[4];
  vtkSpherePackingSplit(view.Near, range[0], range[2]);
  vtkSpherePackingSplit(view.Far, range[1], range[3]);
  program->SetUniformMatrix3x3("viewHigh", rows[0]);
  program->SetUniformMatrix3x3("viewLow", rows[1]);
  program->SetUniform3f("eyeHigh", eye[0]);
  program->SetUniform3f("eyeLow", eye[1]);
  program->SetUniform4f("pixelMapHigh", pixelMap[0]);
  program->SetUniform4f("pixelMapLow", pixelMap[1]);
  program->SetUniform4f("clipRange", range);
  program->SetUniform4f("viewport", viewport);
  program->SetUniformf("radiusScale", static_cast<float>(view.RadiusScale));
  program->SetUniformf("maximumDepthShare", vtkSpherePackingMaximumDepthShare);
  program->SetUniformf("maximumPointSize", maximumPointSize);
  program->SetUniformi("cameraParallel", view.Parallel ? 1 : 0);
}

//------------------------------------------------------------------------------
void vtkSpherePackingSetRayUniforms(vtkShaderProgram* program, const vtkSpherePackingView& view)
{
  const double length = view.Far - view.Near;
  float rayMap[2][4];
  for (int axis = 0; axis < 2; ++axis)
  {
    const double factor = 1.0 / view.PixelMap[axis];
    const double offset = -(view.PixelMap[2 + axis] + view.Viewport[axis]) * factor;
    vtkSpherePackingSplit(factor, rayMap[0][axis], rayMap[1][axis]);
    vtkSpherePackingSplit(offset, rayMap[0][2 + axis], rayMap[1][2 + axis]);
  }
  program->SetUniform4f("rayMapHigh", rayMap[0]);
  program->SetUniform4f("rayMapLow", rayMap[1]);
  const float depthMap[3] = { static_cast<float>(view.Near), static_cast<float>(length),
    static_cast<float>(view.Near / length) };
  program->SetUniform3f("depthMap", depthMap);
}

//------------------------------------------------------------------------------
void vtkSpherePackingAddPointAttributes(vtkOpenGLVertexArrayObject* vao, vtkShaderProgram* program,
  vtkOpenGLBufferObject* vertices, vtkOpenGLBufferObject* ids)
{
  using V = vtkSpherePackingVertex;
  vao->Bind();
  const AttributeAdder add{ vao, program, vertices, sizeof(V) };
  add.Floats("centerHigh", offsetof(V, High), 3);
  add.Floats("centerLow", offsetof(V, Low), 3);
  add.Floats("radius", offsetof(V, Radius), 1);
  add.Bytes("sphereColor", offsetof(V, Color), true);
  AttributeAdder{ vao, program, ids, 4 }.Bytes("sphereId", 0, false);
}

//------------------------------------------------------------------------------
void vtkSpherePackingAddQuadAttributes(
  vtkOpenGLVertexArrayObject* vao, vtkShaderProgram* program, vtkOpenGLBufferObject* quads)
{
  using V = vtkSpherePackingQuadVertex;
  vao->Bind();
  const AttributeAdder add{ vao, program, quads, sizeof(V) };
  add.Floats("corner", offsetof(V, Corner), 3);
  add.Floats("sphereReference", offsetof(V, Reference), 4);
  add.Floats("sphereShape", offsetof(V, Shape), 4);
  add.Floats("sphereShapeLow", offsetof(V, ShapeLow), 4);
  add.Floats("sphereRest", offsetof(V, Rest), 4);
  add.Bytes("sphereColor", offsetof(V, Color), true);
  add.Bytes("sphereId", offsetof(V, Id), false);
}
VTK_ABI_NAMESPACE_END
