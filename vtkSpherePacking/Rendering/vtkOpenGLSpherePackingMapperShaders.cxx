// SPDX-License-Identifier: BSD-3-Clause
// The part of vtkOpenGLSpherePackingMapper that puts shaders together and feeds them.
#include "vtkOpenGLSpherePackingMapper.h"

#include "vtkOpenGLSpherePackingMapperInternals.h"

#include "vtkActor.h"
#include "vtkCamera.h"
#include "vtkHardwareSelector.h"
#include "vtkOpenGLVertexArrayObject.h"
#include "vtkProperty.h"
#include "vtkRenderer.h"
#include "vtkShaderProgram.h"
#include "vtkSpherePackingSplit.h"

#include "vtkSpherePackingFSDeclarations.h"
#include "vtkSpherePackingFSDepth.h"
#include "vtkSpherePackingFSHit.h"
#include "vtkSpherePackingFSNormal.h"
#include "vtkSpherePackingQuadVS.h"
#include "vtkSpherePackingVS.h"

#include <algorithm>
#include <cstddef>

namespace
{
using ShaderMap = std::map<vtkShader::Type, vtkShader*>;

void Substitute(
  const ShaderMap& shaders, vtkShader::Type type, const char* token, const std::string& text)
{
  std::string source = shaders.at(type)->GetSource();
  vtkShaderProgram::Substitute(source, token, text);
  shaders.at(type)->SetSource(source);
}
}

//------------------------------------------------------------------------------
void vtkOpenGLSpherePackingMapper::Internals::UploadIds()
{
  const std::vector<vtkIdType>& ids = this->Vertices.GetPointIds();
  std::vector<unsigned char> bytes(4 * ids.size());
  for (std::size_t i = 0; i < ids.size(); ++i)
  {
    vtkSpherePackingFillId(&bytes[4 * i], ids[i]);
  }
  this->IdBuffer->Upload(bytes, vtkOpenGLBufferObject::ArrayBuffer);
  this->IdsUploaded = true;
  this->BufferTime.Modified();
}

//------------------------------------------------------------------------------
bool vtkOpenGLSpherePackingMapper::GetNeedToRebuildShaders(
  vtkOpenGLHelper& cellBO, vtkRenderer* ren, vtkActor* act)
{
  Internals& impl = *this->Impl;
  if (impl.HasColors != impl.ShadersHaveColors || impl.MayBeCut != impl.ShadersMayCut)
  {
    impl.ShadersHaveColors = impl.HasColors;
    impl.ShadersMayCut = impl.MayBeCut;
    this->SelectionStateChanged.Modified(); // the superclass rebuilds every program after this
  }
  return this->Superclass::GetNeedToRebuildShaders(cellBO, ren, act);
}

//------------------------------------------------------------------------------
void vtkOpenGLSpherePackingMapper::GetShaderTemplate(
  ShaderMap shaders, vtkRenderer* ren, vtkActor* act)
{
  this->Superclass::GetShaderTemplate(shaders, ren, act);
  shaders[vtkShader::Vertex]->SetSource(
    this->DrawingQuads() ? vtkSpherePackingQuadVS : vtkSpherePackingVS);
  shaders[vtkShader::Geometry]->SetSource("");
  for (const vtkShader::Type type : { vtkShader::Vertex, vtkShader::Fragment })
  {
    Substitute(shaders, type, "//VTK::System::Dec",
      "//VTK::System::Dec\n"
      "#extension GL_ARB_gpu_shader_fp64 : enable\n"
      "#ifdef GL_ARB_gpu_shader_fp64\n"
      "#define REAL double\n#define REAL2 dvec2\n#define REAL3 dvec3\n#define REAL4 dvec4\n"
      "#else\n"
      "#define REAL float\n#define REAL2 vec2\n#define REAL3 vec3\n#define REAL4 vec4\n"
      "#endif\n");
  }
  // The rasterised depth is that of the sphere's front, so early depth tests may reject.
  Substitute(shaders, vtkShader::Fragment, "//VTK::System::Dec",
    "//VTK::System::Dec\n"
    "#extension GL_ARB_conservative_depth : enable\n");
}

//------------------------------------------------------------------------------
void vtkOpenGLSpherePackingMapper::ReplaceShaderPositionVC(
  ShaderMap shaders, vtkRenderer* ren, vtkActor*)
{
  const bool parallel = ren->GetActiveCamera()->GetParallelProjection() != 0;
  Substitute(shaders, vtkShader::Fragment, "//VTK::Camera::Dec", "uniform int cameraParallel;\n");
  Substitute(shaders, vtkShader::Fragment, "//VTK::PositionVC::Dec",
    std::string("#ifdef GL_ARB_conservative_depth\n"
                "layout(depth_greater) out float gl_FragDepth;\n"
                "#endif\n") +
      (this->DrawingQuads() ? "#define DRAWING_QUADS\n" : "") +
      (this->Impl->MayBeCut ? "#define SPHERES_MAY_BE_CUT\n" : "") +
      "#define CLIPPING_PLANES " + std::to_string(this->GetNumberOfClippingPlanes()) +
      "\nconst bool parallelView = " + (parallel ? "true" : "false") + ";\n" + vtkSpherePackingFSDeclarations);
  Substitute(shaders, vtkShader::Fragment, "//VTK::PositionVC::Impl", vtkSpherePackingFSHit);
  Substitute(shaders, vtkShader::Fragment, "//VTK::Depth::Impl", vtkSpherePackingFSDepth);
}

//------------------------------------------------------------------------------
void vtkOpenGLSpherePackingMapper::ReplaceShaderNormal(ShaderMap shaders, vtkRenderer*, vtkActor*)
{
  Substitute(shaders, vtkShader::Fragment, "//VTK::Normal::Impl", vtkSpherePackingFSNormal);
}

//------------------------------------------------------------------------------
void vtkOpenGLSpherePackingMapper::ReplaceShaderLight(
  ShaderMap shaders, vtkRenderer* ren, vtkActor* act)
{
  this->Superclass::ReplaceShaderLight(shaders, ren, act);
  // VTK computes a power a light even where nothing shines. As a constant 0 the compiler drops
  // all of it, which halves a frame under PyVista's five lights on a software rasteriser.
  if (act->GetProperty()->GetSpecular() == 0.0)
  {
    Substitute(shaders, vtkShader::Fragment, "uniform float specularIntensity;",
      "const float specularIntensity = 0.0;");
  }
}

//------------------------------------------------------------------------------
void vtkOpenGLSpherePackingMapper::ReplaceShaderEdges(ShaderMap shaders, vtkRenderer*, vtkActor*)
{
  // Comes right after the superclass set the colours of the material.
  if (!this->Impl->HasColors)
  {
    return;
  }
  Substitute(shaders, vtkShader::Vertex, "//VTK::Color::Dec",
    "in vec4 sphereColor;\nflat out vec4 sphereColorVSOutput;\n");
  Substitute(
    shaders, vtkShader::Vertex, "//VTK::Color::Impl", "sphereColorVSOutput = sphereColor;\n");
  Substitute(
    shaders, vtkShader::Fragment, "//VTK::Edges::Dec", "flat in vec4 sphereColorVSOutput;\n");
  Substitute(shaders, vtkShader::Fragment, "//VTK::Edges::Impl",
    "  ambientColor = ambientIntensity * sphereColorVSOutput.rgb;\n"
    "  diffuseColor = diffuseIntensity * sphereColorVSOutput.rgb;\n"
    "  opacity = opacityUniform * sphereColorVSOutput.a;\n");
}

//------------------------------------------------------------------------------
void vtkOpenGLSpherePackingMapper::ReplaceShaderClip(ShaderMap, vtkRenderer*, vtkActor*)
{
  // The hit itself heeds the planes: see sphereHitIsVisible() in the declarations.
}

//------------------------------------------------------------------------------
void vtkOpenGLSpherePackingMapper::ReplaceShaderPicking(
  ShaderMap shaders, vtkRenderer* ren, vtkActor* act)
{
  const char* value = nullptr;
  switch (this->LastSelectionState)
  {
    case vtkHardwareSelector::POINT_ID_LOW24:
    case vtkHardwareSelector::CELL_ID_LOW24:
      value = "vec4(sphereIdVSOutput.xyz / 255.0, 1.0)";
      break;
    case vtkHardwareSelector::POINT_ID_HIGH24:
    case vtkHardwareSelector::CELL_ID_HIGH24:
      value = "vec4(sphereIdVSOutput.w / 255.0, 0.0, 0.0, 1.0)";
      break;
    default:
      this->Superclass::ReplaceShaderPicking(shaders, ren, act);
      return;
  }
  Substitute(shaders, vtkShader::Vertex, "//VTK::Picking::Dec",
    "in vec4 sphereId;\nflat out vec4 sphereIdVSOutput;\n");
  Substitute(shaders, vtkShader::Vertex, "//VTK::Picking::Impl", "sphereIdVSOutput = sphereId;\n");
  Substitute(
    shaders, vtkShader::Fragment, "//VTK::Picking::Dec", "flat in vec4 sphereIdVSOutput;\n");
  Substitute(shaders, vtkShader::Fragment, "//VTK::Picking::Impl",
    std::string("gl_FragData[0] = ") + value + ";\n");
}

//------------------------------------------------------------------------------
void vtkOpenGLSpherePackingMapper::ReplaceShaderCoincidentOffset(
  ShaderMap, vtkRenderer*, vtkActor*)
{
  // Spheres coincide with nothing else; the depth is the hit's own.
}

//------------------------------------------------------------------------------
void vtkOpenGLSpherePackingMapper::AddAttributes(vtkOpenGLHelper& cellBO)
{
  Internals& impl = *this->Impl;
  vtkShaderProgram* program = cellBO.Program;
  vtkOpenGLVertexArrayObject* vao = cellBO.VAO;
  const bool quads = this->DrawingQuads();
  vtkOpenGLBufferObject* buffer = quads ? impl.QuadBuffer : impl.VertexBuffer;
  const std::size_t stride =
    quads ? sizeof(vtkSpherePackingQuadVertex) : sizeof(vtkSpherePackingVertex);
  const auto add = [&](const char* name, std::size_t offset, int components)
  {
    vao->AddAttributeArray(
      program, buffer, name, static_cast<int>(offset), stride, VTK_FLOAT, components, false);
  };
  const auto addBytes = [&](vtkOpenGLBufferObject* from, const char* name, std::size_t offset,
                          std::size_t step, bool normalize)
  {
    if (program->IsAttributeUsed(name))
    {
      vao->AddAttributeArray(program, from, name, static_cast<int>(offset), step,
        VTK_UNSIGNED_CHAR, 4, normalize);
    }
  };
  vao->Bind();
  if (quads)
  {
    using V = vtkSpherePackingQuadVertex;
    add("corner", offsetof(V, Corner), 3);
    add("sphereReference", offsetof(V, Reference), 4);
    add("sphereShape", offsetof(V, Shape), 4);
    add("sphereShapeLow", offsetof(V, ShapeLow), 4);
    add("sphereRest", offsetof(V, Rest), 4);
    addBytes(buffer, "sphereColor", offsetof(V, Color), stride, true);
    addBytes(buffer, "sphereId", offsetof(V, Id), stride, false);
  }
  else
  {
    using V = vtkSpherePackingVertex;
    add("centerHigh", offsetof(V, High), 3);
    add("centerLow", offsetof(V, Low), 3);
    add("radius", offsetof(V, Radius), 1);
    addBytes(buffer, "sphereColor", offsetof(V, Color), stride, true);
    addBytes(impl.IdBuffer, "sphereId", 0, 4, false);
  }
  cellBO.AttributeUpdateTime.Modified();
}

//------------------------------------------------------------------------------
void vtkOpenGLSpherePackingMapper::SetMapperShaderParameters(
  vtkOpenGLHelper& cellBO, vtkRenderer* ren, vtkActor* act)
{
  Internals& impl = *this->Impl;
  this->Superclass::SetMapperShaderParameters(cellBO, ren, act);
  if (impl.BufferTime > cellBO.AttributeUpdateTime ||
    cellBO.ShaderSourceTime > cellBO.AttributeUpdateTime ||
    cellBO.VAO->GetMTime() > cellBO.AttributeUpdateTime.GetMTime())
  {
    this->AddAttributes(cellBO);
  }
  vtkShaderProgram* program = cellBO.Program;
  program->SetUniformi("hitMode", impl.HitMode);
  // VTK tests picks of points against the depth of the picture before; a step nearer they pass.
  program->SetUniformf("depthShift", ren->GetSelector() ? 5e-7f : 0.0f);
  const int count = this->GetNumberOfClippingPlanes();
  if (count > 0)
  {
    std::vector<std::array<float, 4>> planes(count);
    for (int i = 0; i < count; ++i)
    {
      double plane[4];
      this->GetClippingPlaneInDataCoords(act->GetMatrix(), i, plane);
      planes[i] = impl.View.ToNearPlaneSpace(plane, impl.Vertices.GetOrigin());
    }
    program->SetUniform4fv("sphereClipPlanes", count, planes.front().data());
  }
}

//------------------------------------------------------------------------------
void vtkOpenGLSpherePackingMapper::SetCameraShaderParameters(
  vtkOpenGLHelper& cellBO, vtkRenderer* ren, vtkActor*)
{
  const vtkSpherePackingView& view = this->Impl->View;
  vtkShaderProgram* program = cellBO.Program;
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
  if (program->IsUniformUsed("cameraParallel"))
  {
    program->SetUniformi(
      "cameraParallel", ren->GetActiveCamera()->GetParallelProjection() ? 1 : 0);
  }
  if (this->DrawingQuads())
  {
    return;
  }

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
  program->SetUniformf("maximumPointSize", this->Impl->MaximumPointSize);
}
