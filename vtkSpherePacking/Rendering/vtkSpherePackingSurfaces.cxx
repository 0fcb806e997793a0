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
#include "vtkSpherePackingOccludersFS.h"
#include "vtkSpherePackingQuadVS.h"
#include "vtkSpherePackingScreenVS.h"
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
  vtkShaderProgram::Substitute(
    vertex, "//VTK::System::Dec", "//VTK::System::Dec\n#define SPHERES_MAY_BE_HIDDEN\n");
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

  this->DrawQuads(window, scene); // the largest, so they hide most
  for (std::size_t phase = 0; phase < scene.Phases.size(); ++phase)
  {
    if (phase > 0)
    {
      this->FindOccluders(window, scene);
    }
    this->DrawPoints(window, scene, phase);
  }
  state->PopFramebufferBindings();
  vtkOpenGLStaticCheckErrorMacro("failed after finding the surfaces of spheres");
}

//------------------------------------------------------------------------------
bool vtkSpherePackingSurfaces::Ready(
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
    return false; // VTK has reported what does not compile
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
  return true;
}

//------------------------------------------------------------------------------
void vtkSpherePackingSurfaces::DrawQuads(vtkOpenGLRenderWindow* window, const Scene& scene)
{
  Scene quads = scene;
  quads.Features.Quads = true;
  if (scene.NumberOfQuadVertices > 0 && this->Ready(window, quads, this->Quads))
  {
    glDrawArrays(GL_TRIANGLES, 0, scene.NumberOfQuadVertices);
    this->Quads.Helper.VAO->Release();
  }
}

//------------------------------------------------------------------------------
void vtkSpherePackingSurfaces::DrawPoints(
  vtkOpenGLRenderWindow* window, const Scene& scene, std::size_t phase)
{
  const vtkSpherePackingRuns& runs = scene.Phases[phase];
  if (runs.Firsts.empty() || !this->Ready(window, scene, this->Points))
  {
    return;
  }
  vtkShaderProgram* program = this->Points.Helper.Program;
  vtkSpherePackingSetPointUniforms(program, scene.View, scene.MaximumPointSize);
  const bool look = phase > 0;
  program->SetUniformi("occluderTile", look ? scene.OccluderTile : 0);
  if (look)
  {
    this->Occluders->Activate();
    program->SetUniformi("occluders", this->Occluders->GetTextureUnit());
  }
  glMultiDrawArrays(
    GL_POINTS, runs.Firsts.data(), runs.Counts.data(), static_cast<GLsizei>(runs.Firsts.size()));
  if (look)
  {
    this->Occluders->Deactivate();
  }
  this->Points.Helper.VAO->Release();
}

//------------------------------------------------------------------------------
void vtkSpherePackingSurfaces::FindOccluders(vtkOpenGLRenderWindow* window, const Scene& scene)
{
  const auto tiles = [&](double pixels)
  { return (static_cast<unsigned int>(pixels) + scene.OccluderTile - 1) / scene.OccluderTile; };
  const unsigned int width = tiles(scene.View.Viewport[2]);
  const unsigned int height = tiles(scene.View.Viewport[3]);
  if (this->Occluders->GetWidth() != width || this->Occluders->GetHeight() != height ||
    !this->Occluders->GetHandle())
  {
    this->Occluders->SetContext(window);
    this->Occluders->SetInternalFormat(GL_R32F);
    this->Occluders->SetFormat(GL_RED);
    this->Occluders->SetDataType(GL_FLOAT);
    this->Occluders->Create2D(width, height, 1, VTK_FLOAT, false);
  }
  vtkOpenGLState* state = window->GetState();
  vtkOpenGLState::ScopedglViewport viewport(state);
  vtkOpenGLState::ScopedglScissor scissor(state);
  vtkOpenGLState::ScopedglEnableDisable test(state, GL_DEPTH_TEST);
  state->PushFramebufferBindings();
  this->OccluderFramebuffer->SetContext(window);
  this->OccluderFramebuffer->Bind();
  this->OccluderFramebuffer->AddColorAttachment(0, this->Occluders);
  this->OccluderFramebuffer->ActivateDrawBuffers(1);
  state->vtkglViewport(0, 0, static_cast<int>(width), static_cast<int>(height));
  state->vtkglScissor(0, 0, static_cast<int>(width), static_cast<int>(height));
  state->vtkglDisable(GL_DEPTH_TEST);

  vtkShaderProgram* program = window->GetShaderCache()->ReadyShaderProgram(
    vtkSpherePackingScreenVS, vtkSpherePackingOccludersFS, "");
  if (program)
  {
    this->Depths->Activate();
    program->SetUniformi("sphereDepths", this->Depths->GetTextureUnit());
    program->SetUniformi("occluderTile", scene.OccluderTile);
    this->OccluderHelper.VAO->Bind();
    glDrawArrays(GL_TRIANGLES, 0, 3);
    this->OccluderHelper.VAO->Release();
    this->Depths->Deactivate();
  }
  state->PopFramebufferBindings();
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
  this->OccluderFramebuffer->ReleaseGraphicsResources(window);
  this->Occluders->ReleaseGraphicsResources(window);
  this->OccluderHelper.ReleaseGraphicsResources(window);
  this->Points.Helper.ReleaseGraphicsResources(window);
  this->Quads.Helper.ReleaseGraphicsResources(window);
}
VTK_ABI_NAMESPACE_END
