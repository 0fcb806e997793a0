// SPDX-License-Identifier: BSD-3-Clause
#include "impostor/GBuffer.h"

#include "vtkOpenGLError.h"
#include "vtkOpenGLFramebufferObject.h"
#include "vtkOpenGLRenderWindow.h"
#include "vtkOpenGLShaderCache.h"
#include "vtkOpenGLState.h"
#include "vtkOpenGLVertexArrayObject.h"
#include "vtkShaderProgram.h"
#include "vtkTextureObject.h"
#include "vtk_glad.h"

#include "GBufferFS.h"

namespace spherepacking
{
namespace
{
vtkShaderProgram* MakeProgram(
  vtkOpenGLRenderWindow* window, const ShaderVariant& variant, ProgramKind kind)
{
  std::string vertex = VertexShader(kind);
  std::string fragment = GBufferFS;
  AddRealTypes(vertex);
  AddRealTypes(fragment);
  vtkShaderProgram::Substitute(
    vertex, "//VTK::System::Dec", "//VTK::System::Dec\n#define HI_Z_CULLING\n");
  if (variant.Colors)
  {
    AddColors(vertex, true);
    vtkShaderProgram::Substitute(
      fragment, "//VTK::System::Dec", "//VTK::System::Dec\n#define SPHERES_HAVE_COLORS\n");
  }
  vtkShaderProgram::Substitute(
    fragment, "//SpherePacking::RaySphere::Dec", RaySphereDeclarations(variant, kind));
  return window->GetShaderCache()->ReadyShaderProgram(vertex.c_str(), fragment.c_str(), "");
}
}

//------------------------------------------------------------------------------
GBuffer::GBuffer() = default;
GBuffer::~GBuffer() = default;

//------------------------------------------------------------------------------
void GBuffer::PrepareFramebuffer(vtkOpenGLRenderWindow* window, const ViewTransform& view)
{
  const unsigned int width = static_cast<unsigned int>(view.Viewport[2]);
  const unsigned int height = static_cast<unsigned int>(view.Viewport[3]);
  this->Framebuffer->SetContext(window);
  if (this->Texels->GetWidth() != width || this->Texels->GetHeight() != height ||
    !this->Texels->GetHandle())
  {
    this->Texels->SetContext(window);
    this->Texels->SetInternalFormat(GL_RGBA32UI);
    this->Texels->SetFormat(GL_RGBA_INTEGER);
    this->Texels->SetDataType(GL_UNSIGNED_INT);
    this->Texels->Create2D(width, height, 4, VTK_UNSIGNED_INT, false);
    this->Depths->SetContext(window);
    this->Depths->AllocateDepth(width, height, vtkTextureObject::Float32);
  }
  this->Framebuffer->Bind();
  this->Framebuffer->AddColorAttachment(0, this->Texels);
  this->Framebuffer->AddDepthAttachment(this->Depths);
  this->Framebuffer->ActivateDrawBuffers(1);
}

//------------------------------------------------------------------------------
void GBuffer::Draw(vtkOpenGLRenderWindow* window, const FrameData& frame)
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
  this->PrepareFramebuffer(window, frame.View);
  const int width = static_cast<int>(frame.View.Viewport[2]);
  const int height = static_cast<int>(frame.View.Viewport[3]);
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
  const GLuint background[4] = { 0x3f800000u, 0, 0, 0 }; // the depth 1.0f
  glClearBufferuiv(GL_COLOR, 0, background);

  this->DrawQuads(window, frame); // first, since the largest occlude most
  for (std::size_t batch = 0; batch < frame.Batches.size(); ++batch)
  {
    if (batch > 0)
    {
      this->HiZ.Update(window, this->Depths, frame.HiZTileSize);
    }
    this->DrawSprites(window, frame, batch);
  }
  state->PopFramebufferBindings();
  vtkOpenGLStaticCheckErrorMacro("failed after finding the surfaces of spheres");
}

//------------------------------------------------------------------------------
bool GBuffer::UseProgram(
  vtkOpenGLRenderWindow* window, const FrameData& frame, GeometryProgram& program)
{
  vtkOpenGLHelper& helper = program.Helper;
  if (!helper.Program || program.Variant != frame.Variant)
  {
    vtkShaderProgram* made = MakeProgram(window, frame.Variant, program.Kind);
    program.Variant = frame.Variant;
    if (made != helper.Program)
    {
      helper.Program = made;
      helper.VAO->ReleaseGraphicsResources();
      helper.AttributeUpdateTime = vtkTimeStamp();
    }
  }
  else
  {
    window->GetShaderCache()->ReadyShaderProgram(helper.Program);
  }
  if (!helper.Program)
  {
    return false; // VTK has reported what does not compile
  }
  helper.VAO->Bind();
  if (frame.Buffers->BufferTime > helper.AttributeUpdateTime)
  {
    frame.Buffers->AddAttributes(helper, program.Kind);
    helper.AttributeUpdateTime.Modified();
  }
  SetRayUniforms(helper.Program, frame.View);
  helper.Program->SetUniformi("hitMode", 0);
  if (!frame.ClippingPlanes.empty())
  {
    helper.Program->SetUniform4fv("sphereClipPlanes", static_cast<int>(frame.ClippingPlanes.size()),
      frame.ClippingPlanes.front().data());
  }
  return true;
}

//------------------------------------------------------------------------------
void GBuffer::DrawQuads(vtkOpenGLRenderWindow* window, const FrameData& frame)
{
  const auto count = static_cast<GLsizei>(frame.Buffers->NumberOfQuadVertices);
  if (count > 0 && this->UseProgram(window, frame, this->Quads))
  {
    glDrawArrays(GL_TRIANGLES, 0, count);
    this->Quads.Helper.VAO->Release();
  }
}

//------------------------------------------------------------------------------
void GBuffer::DrawSprites(vtkOpenGLRenderWindow* window, const FrameData& frame, std::size_t batch)
{
  const DrawRanges& ranges = frame.Batches[batch];
  if (ranges.Firsts.empty() || !this->UseProgram(window, frame, this->Sprites))
  {
    return;
  }
  vtkShaderProgram* program = this->Sprites.Helper.Program;
  SetSpriteUniforms(program, frame.View, frame.MaximumPointSize);
  const bool culls = batch > 0;
  program->SetUniformi("hiZTileSize", culls ? frame.HiZTileSize : 0);
  if (culls)
  {
    this->HiZ.Activate(program);
  }
  glMultiDrawArrays(GL_POINTS, ranges.Firsts.data(), ranges.Counts.data(),
    static_cast<GLsizei>(ranges.Firsts.size()));
  if (culls)
  {
    this->HiZ.Deactivate();
  }
  this->Sprites.Helper.VAO->Release();
}

//------------------------------------------------------------------------------
void GBuffer::Activate(vtkShaderProgram* program)
{
  this->Texels->Activate();
  program->SetUniformi("gBuffer", this->Texels->GetTextureUnit());
}

//------------------------------------------------------------------------------
void GBuffer::Deactivate()
{
  this->Texels->Deactivate();
}

//------------------------------------------------------------------------------
void GBuffer::ReleaseGraphicsResources(vtkWindow* window)
{
  this->Framebuffer->ReleaseGraphicsResources(window);
  this->Texels->ReleaseGraphicsResources(window);
  this->Depths->ReleaseGraphicsResources(window);
  this->HiZ.ReleaseGraphicsResources(window);
  this->Sprites.Helper.ReleaseGraphicsResources(window);
  this->Quads.Helper.ReleaseGraphicsResources(window);
}
}
