// SPDX-License-Identifier: BSD-3-Clause
#include "vtkSpherePackingSurfaces.h"

#include "vtkOpenGLBufferObject.h"
#include "vtkOpenGLError.h"
#include "vtkOpenGLFramebufferObject.h"
#include "vtkOpenGLRenderWindow.h"
#include "vtkOpenGLShaderCache.h"
#include "vtkOpenGLState.h"
#include "vtkOpenGLVertexArrayObject.h"
#include "vtkShaderProgram.h"
#include "vtkTextureObject.h"
#include "vtk_glad.h"

#include "vtkSpherePackingFSHit.h"
#include "vtkSpherePackingQuadVS.h"
#include "vtkSpherePackingSurfaceFS.h"
#include "vtkSpherePackingVS.h"

VTK_ABI_NAMESPACE_BEGIN
namespace
{
vtkShaderProgram* MakeProgram(
  vtkOpenGLRenderWindow* window, const vtkSpherePackingFeatures& features)
{
  std::string vertex = features.Quads ? vtkSpherePackingQuadVS : vtkSpherePackingVS;
  std::string fragment = vtkSpherePackingSurfaceFS;
  for (std::string* source : { &vertex, &fragment })
  {
    vtkShaderProgram::Substitute(*source, "//VTK::System::Dec", vtkSpherePackingRealTypes);
  }
  if (features.Colors)
  {
    vertex = vtkSpherePackingWithColors(vertex, true);
    vtkShaderProgram::Substitute(
      fragment, "//VTK::System::Dec", "//VTK::System::Dec\n#define SPHERES_HAVE_COLORS\n");
  }
  vtkShaderProgram::Substitute(
    fragment, "//VTK::SpherePacking::Dec", vtkSpherePackingHitDeclarations(features));
  vtkShaderProgram::Substitute(fragment, "//VTK::SpherePacking::Impl", vtkSpherePackingFSHit);
  return window->GetShaderCache()->ReadyShaderProgram(vertex.c_str(), fragment.c_str(), "");
}
}

//------------------------------------------------------------------------------
vtkSpherePackingSurfaces::vtkSpherePackingSurfaces() = default;
vtkSpherePackingSurfaces::~vtkSpherePackingSurfaces() = default;

//------------------------------------------------------------------------------
void vtkSpherePackingSurfaces::Prepare(vtkOpenGLRenderWindow* window, const Scene& scene)
{
  const unsigned int width = static_cast<unsigned int>(scene.View.Viewport[2]);
  const unsigned int height = static_cast<unsigned int>(scene.View.Viewport[3]);
  this->Framebuffer->SetContext(window);
  if (this->Surfaces->GetWidth() != width || this->Surfaces->GetHeight() != height ||
    !this->Surfaces->GetHandle())
  {
    this->Surfaces->SetContext(window);
    this->Surfaces->SetInternalFormat(GL_RGBA32UI);
    this->Surfaces->SetFormat(GL_RGBA_INTEGER);
    this->Surfaces->SetDataType(GL_UNSIGNED_INT);
    this->Surfaces->Create2D(width, height, 4, VTK_UNSIGNED_INT, false);
    this->Depths->SetContext(window);
    this->Depths->AllocateDepth(width, height, vtkTextureObject::Float32);
  }
  this->Framebuffer->Bind();
  this->Framebuffer->AddColorAttachment(0, this->Surfaces);
  this->Framebuffer->AddDepthAttachment(this->Depths);
  this->Framebuffer->ActivateDrawBuffers(1);
}

//------------------------------------------------------------------------------
void vtkSpherePackingSurfaces::Draw(vtkOpenGLRenderWindow* window, Scene scene)
{
  vtkOpenGLState* state = window->GetState();
  vtkOpenGLState::ScopedglViewport viewport(state);
  vtkOpenGLState::ScopedglScissor scissor(state);
  vtkOpenGLState::ScopedglDepthMask depthMask(state);
  vtkOpenGLState::ScopedglDepthFunc depthFunction(state);
  vtkOpenGLState::ScopedglColorMask colorMask(state);
  vtkOpenGLState::ScopedglEnableDisable blend(state, GL_BLEND);
  vtkOpenGLState::ScopedglEnableDisable cull(state, GL_CULL_FACE);
  vtkOpenGLState::ScopedglEnableDisable test(state, GL_DEPTH_TEST);
  vtkOpenGLState::ScopedglEnableDisable pointSize(state, GL_PROGRAM_POINT_SIZE);

  state->PushFramebufferBindings();
  this->Prepare(window, scene);
  const int width = static_cast<int>(scene.View.Viewport[2]);
  const int height = static_cast<int>(scene.View.Viewport[3]);
  state->vtkglViewport(0, 0, width, height);
  state->vtkglScissor(0, 0, width, height);
  state->vtkglDepthMask(GL_TRUE);
  state->vtkglDepthFunc(GL_LEQUAL);
  state->vtkglColorMask(GL_TRUE, GL_TRUE, GL_TRUE, GL_TRUE);
  state->vtkglDisable(GL_BLEND);
  state->vtkglDisable(GL_CULL_FACE);
  state->vtkglEnable(GL_DEPTH_TEST);
  state->vtkglEnable(GL_PROGRAM_POINT_SIZE);
  state->vtkglClearDepth(1.0);
  state->vtkglClear(GL_DEPTH_BUFFER_BIT);
  const GLuint nothing[4] = { 0x3f800000u, 0, 0, 0 }; // the depth 1
  glClearBufferuiv(GL_COLOR, 0, nothing);

  scene.Features.Quads = false;
  this->DrawStage(window, scene, this->Points);
  if (scene.NumberOfQuadVertices > 0)
  {
    scene.Features.Quads = true;
    this->DrawStage(window, scene, this->Quads);
  }
  state->PopFramebufferBindings();
  vtkOpenGLStaticCheckErrorMacro("failed after finding the surfaces of spheres");
}

//------------------------------------------------------------------------------
void vtkSpherePackingSurfaces::DrawStage(
  vtkOpenGLRenderWindow* window, const Scene& scene, Stage& stage)
{
  vtkOpenGLHelper& helper = stage.Helper;
  if (!helper.Program || stage.Features != scene.Features)
  {
    vtkShaderProgram* program = MakeProgram(window, scene.Features);
    stage.Features = scene.Features;
    if (program != helper.Program)
    {
      helper.Program = program;
      helper.VAO->ReleaseGraphicsResources();
      helper.AttributeUpdateTime = vtkTimeStamp();
    }
  }
  else
  {
    window->GetShaderCache()->ReadyShaderProgram(helper.Program);
  }
  vtkShaderProgram* program = helper.Program;
  if (!program)
  {
    return; // VTK has reported what does not compile
  }
  helper.VAO->Bind();
  if (scene.BufferTime > helper.AttributeUpdateTime)
  {
    if (scene.Features.Quads)
    {
      vtkSpherePackingAddQuadAttributes(helper.VAO, program, scene.Quads);
    }
    else
    {
      vtkSpherePackingAddPointAttributes(helper.VAO, program, scene.Vertices, nullptr);
    }
    helper.AttributeUpdateTime.Modified();
  }
  vtkSpherePackingSetRayUniforms(program, scene.View);
  program->SetUniformi("hitMode", 0);
  if (!scene.ClippingPlanes.empty())
  {
    program->SetUniform4fv("sphereClipPlanes", static_cast<int>(scene.ClippingPlanes.size()),
      scene.ClippingPlanes.front().data());
  }
  if (scene.Features.Quads)
  {
    glDrawArrays(GL_TRIANGLES, 0, scene.NumberOfQuadVertices);
  }
  else
  {
    vtkSpherePackingSetPointUniforms(program, scene.View, scene.MaximumPointSize);
    glDrawArrays(GL_POINTS, 0, scene.NumberOfVertices);
  }
  helper.VAO->Release();
}

//------------------------------------------------------------------------------
void vtkSpherePackingSurfaces::Activate(vtkShaderProgram* program)
{
  this->Surfaces->Activate();
  program->SetUniformi("sphereSurfaces", this->Surfaces->GetTextureUnit());
}

//------------------------------------------------------------------------------
void vtkSpherePackingSurfaces::Deactivate()
{
  this->Surfaces->Deactivate();
}

//------------------------------------------------------------------------------
void vtkSpherePackingSurfaces::ReleaseGraphicsResources(vtkWindow* window)
{
  this->Framebuffer->ReleaseGraphicsResources(window);
  this->Surfaces->ReleaseGraphicsResources(window);
  this->Depths->ReleaseGraphicsResources(window);
  this->Points.Helper.ReleaseGraphicsResources(window);
  this->Quads.Helper.ReleaseGraphicsResources(window);
}
VTK_ABI_NAMESPACE_END
