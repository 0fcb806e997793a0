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

#include "vtkSpherePackingFSDepth.h"
#include "vtkSpherePackingFSHit.h"
#include "vtkSpherePackingFSNormal.h"
#include "vtkSpherePackingQuadVS.h"
#include "vtkSpherePackingScreenFSDeclarations.h"
#include "vtkSpherePackingScreenFSHit.h"
#include "vtkSpherePackingScreenVS.h"
#include "vtkSpherePackingVS.h"

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
vtkSpherePackingFeatures vtkOpenGLSpherePackingMapper::Internals::GetFeatures(
  int numberOfClippingPlanes) const
{
  vtkSpherePackingFeatures features;
  features.Parallel = this->View.Parallel;
  features.Colors = this->HasColors;
  features.MayBeCut = this->MayBeCut;
  features.ClippingPlanes = numberOfClippingPlanes;
  return features;
}

//------------------------------------------------------------------------------
bool vtkOpenGLSpherePackingMapper::GetNeedToRebuildShaders(
  vtkOpenGLHelper& cellBO, vtkRenderer* ren, vtkActor* act)
{
  Internals& impl = *this->Impl;
  const vtkSpherePackingFeatures features = impl.GetFeatures(this->GetNumberOfClippingPlanes());
  if (features != impl.ShaderFeatures)
  {
    impl.ShaderFeatures = features;
    this->SelectionStateChanged.Modified(); // the superclass rebuilds every program after this
  }
  return this->Superclass::GetNeedToRebuildShaders(cellBO, ren, act);
}

//------------------------------------------------------------------------------
void vtkOpenGLSpherePackingMapper::GetShaderTemplate(
  ShaderMap shaders, vtkRenderer* ren, vtkActor* act)
{
  this->Superclass::GetShaderTemplate(shaders, ren, act);
  std::string vertex = vtkSpherePackingScreenVS;
  if (!this->DrawingScreen())
  {
    vertex = this->DrawingQuads() ? vtkSpherePackingQuadVS : vtkSpherePackingVS;
    vertex = this->Impl->HasColors ? vtkSpherePackingWithColors(vertex, false) : vertex;
  }
  shaders[vtkShader::Vertex]->SetSource(vertex);
  shaders[vtkShader::Geometry]->SetSource("");
  Substitute(shaders, vtkShader::Vertex, "//VTK::System::Dec", vtkSpherePackingRealTypes);
  Substitute(shaders, vtkShader::Fragment, "//VTK::System::Dec", vtkSpherePackingRealTypes);
}

//------------------------------------------------------------------------------
void vtkOpenGLSpherePackingMapper::ReplaceShaderPositionVC(
  ShaderMap shaders, vtkRenderer*, vtkActor*)
{
  vtkSpherePackingFeatures features = this->Impl->ShaderFeatures;
  features.Quads = this->DrawingQuads();
  std::string declarations = vtkSpherePackingHitDeclarations(features);
  std::string hit = vtkSpherePackingFSHit;
  std::string depth = vtkSpherePackingFSDepth;
  if (this->DrawingScreen())
  {
    declarations = std::string("const bool parallelView = ") +
      (features.Parallel ? "true" : "false") + ";\n" + vtkSpherePackingScreenFSDeclarations;
    hit = vtkSpherePackingScreenFSHit;
    depth = "  gl_FragDepth = sphereDepthValue;\n";
  }
  Substitute(shaders, vtkShader::Fragment, "//VTK::Camera::Dec", "uniform int cameraParallel;\n");
  Substitute(shaders, vtkShader::Fragment, "//VTK::PositionVC::Dec", declarations);
  Substitute(shaders, vtkShader::Fragment, "//VTK::PositionVC::Impl", hit);
  Substitute(shaders, vtkShader::Fragment, "//VTK::Depth::Impl", depth);
}

//------------------------------------------------------------------------------
void vtkOpenGLSpherePackingMapper::ReplaceShaderNormal(ShaderMap shaders, vtkRenderer*, vtkActor*)
{
  Substitute(shaders, vtkShader::Fragment, "//VTK::Normal::Impl",
    this->DrawingScreen() ? "  vec3 normalVCVSOutput = vec3(sphereNormal,\n"
                            "    sqrt(max(1.0 - dot(sphereNormal, sphereNormal), 0.0)) *\n"
                            "      ((sphereSurface.x >> 31) != 0u ? -1.0 : 1.0));\n"
                          : vtkSpherePackingFSNormal);
}

//------------------------------------------------------------------------------
void vtkOpenGLSpherePackingMapper::ReplaceShaderLight(
  ShaderMap shaders, vtkRenderer* ren, vtkActor* act)
{
  this->Superclass::ReplaceShaderLight(shaders, ren, act);
  // What a render pass asks of the fragment, as the shadow maps do, is the hit's.
  Substitute(shaders, vtkShader::Fragment, "1.0/gl_FragCoord.w", "-vertexVC.z");
  Substitute(shaders, vtkShader::Fragment, "gl_FragCoord.z", "gl_FragDepth");
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
  const bool screen = this->DrawingScreen();
  const std::string color = screen
    ? "vec4((uvec4(sphereSurface.y) >> uvec4(0u, 8u, 16u, 24u)) & 255u) / 255.0"
    : "sphereColorVSOutput";
  Substitute(shaders, vtkShader::Fragment, "//VTK::Edges::Dec",
    screen ? "" : "flat in vec4 sphereColorVSOutput;\n");
  Substitute(shaders, vtkShader::Fragment, "//VTK::Edges::Impl",
    "  vec4 sphereColorHere = " + color +
      ";\n"
      "  ambientColor = ambientIntensity * sphereColorHere.rgb;\n"
      "  diffuseColor = diffuseIntensity * sphereColorHere.rgb;\n"
      "  opacity = opacityUniform * sphereColorHere.a;\n");
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
void vtkOpenGLSpherePackingMapper::ReplaceShaderCoincidentOffset(ShaderMap, vtkRenderer*, vtkActor*)
{
  // Spheres coincide with nothing else; the depth is the hit's own.
}

//------------------------------------------------------------------------------
void vtkOpenGLSpherePackingMapper::SetMapperShaderParameters(
  vtkOpenGLHelper& cellBO, vtkRenderer* ren, vtkActor* act)
{
  Internals& impl = *this->Impl;
  this->Superclass::SetMapperShaderParameters(cellBO, ren, act);
  vtkShaderProgram* program = cellBO.Program;
  if (this->DrawingScreen())
  {
    cellBO.VAO->Bind(); // without attributes, but drawing needs one
    impl.Surfaces->Activate(program);
    const float origin[2] = { static_cast<float>(impl.View.Viewport[0]),
      static_cast<float>(impl.View.Viewport[1]) };
    program->SetUniform2f("viewportOrigin", origin);
    return;
  }
  if (impl.BufferTime > cellBO.AttributeUpdateTime ||
    cellBO.ShaderSourceTime > cellBO.AttributeUpdateTime ||
    cellBO.VAO->GetMTime() > cellBO.AttributeUpdateTime.GetMTime())
  {
    if (this->DrawingQuads())
    {
      vtkSpherePackingAddQuadAttributes(cellBO.VAO, program, impl.QuadBuffer);
    }
    else
    {
      vtkSpherePackingAddPointAttributes(cellBO.VAO, program, impl.VertexBuffer, impl.IdBuffer);
    }
    cellBO.AttributeUpdateTime.Modified();
  }
  program->SetUniformi("hitMode", impl.HitMode);
  // VTK tests picks of points against the depth of the picture before; a step nearer they pass.
  program->SetUniformf("depthShift", ren->GetSelector() ? 5e-7f : 0.0f);
  const std::vector<std::array<float, 4>> planes = this->ComputeClippingPlanes(act);
  if (!planes.empty())
  {
    program->SetUniform4fv(
      "sphereClipPlanes", static_cast<int>(planes.size()), planes.front().data());
  }
}

//------------------------------------------------------------------------------
void vtkOpenGLSpherePackingMapper::SetCameraShaderParameters(
  vtkOpenGLHelper& cellBO, vtkRenderer*, vtkActor*)
{
  const Internals& impl = *this->Impl;
  vtkShaderProgram* program = cellBO.Program;
  vtkSpherePackingSetRayUniforms(program, impl.View);
  if (!this->DrawingScreen() && !this->DrawingQuads())
  {
    vtkSpherePackingSetPointUniforms(program, impl.View, impl.MaximumPointSize);
  }
  else if (program->IsUniformUsed("cameraParallel"))
  {
    program->SetUniformi("cameraParallel", impl.View.Parallel ? 1 : 0);
  }
}
