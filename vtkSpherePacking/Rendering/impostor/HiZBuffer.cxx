// SPDX-License-Identifier: BSD-3-Clause
#include "impostor/HiZBuffer.h"

#include "vtkOpenGLFramebufferObject.h"
#include "vtkOpenGLRenderWindow.h"
#include "vtkOpenGLShaderCache.h"
#include "vtkOpenGLState.h"
#include "vtkOpenGLVertexArrayObject.h"
#include "vtkShaderProgram.h"
#include "vtkTextureObject.h"
#include "vtk_glad.h"

#include "FullScreenTriangleVS.h"
#include "HiZFS.h"

#include <algorithm>
#include <cmath>

namespace spherepacking
{
//------------------------------------------------------------------------------
int HiZTileSize(const ViewTransform& view, const double bounds[6],
  const std::array<double, 3>& origin, double radius)
{
  std::array<double, 3> middle;
  for (int axis = 0; axis < 3; ++axis)
  {
    middle[axis] = 0.5 * (bounds[2 * axis] + bounds[2 * axis + 1]) - origin[axis];
  }
  const double depth = view.Parallel ? 1.0 : std::max(-view.ToView(middle)[2], view.Near);
  const double pixels = 2.0 * radius * view.RadiusScale * std::abs(view.SlopeToPixel[1]) / depth;
  int size = 4;
  while (size < pixels && size < 32)
  {
    size *= 2;
  }
  return size;
}

//------------------------------------------------------------------------------
HiZBuffer::HiZBuffer() = default;
HiZBuffer::~HiZBuffer() = default;

//------------------------------------------------------------------------------
void HiZBuffer::Update(vtkOpenGLRenderWindow* window, vtkTextureObject* depths, int tileSize)
{
  const auto tiles = [&](unsigned int pixels) { return (pixels + tileSize - 1) / tileSize; };
  const unsigned int width = tiles(depths->GetWidth());
  const unsigned int height = tiles(depths->GetHeight());
  vtkTextureObject* texture = this->FarthestDepths;
  if (texture->GetWidth() != width || texture->GetHeight() != height || !texture->GetHandle())
  {
    texture->SetContext(window);
    texture->SetInternalFormat(GL_R32F);
    texture->SetFormat(GL_RED);
    texture->SetDataType(GL_FLOAT);
    texture->Create2D(width, height, 1, VTK_FLOAT, false);
  }
  vtkOpenGLState* state = window->GetState();
  vtkOpenGLState::ScopedglViewport viewport(state);
  vtkOpenGLState::ScopedglScissor scissor(state);
  vtkOpenGLState::ScopedglEnableDisable test(state, GL_DEPTH_TEST);
  state->PushFramebufferBindings();
  this->Framebuffer->SetContext(window);
  this->Framebuffer->Bind();
  this->Framebuffer->AddColorAttachment(0, texture);
  this->Framebuffer->ActivateDrawBuffers(1);
  state->vtkglViewport(0, 0, static_cast<int>(width), static_cast<int>(height));
  state->vtkglScissor(0, 0, static_cast<int>(width), static_cast<int>(height));
  state->vtkglDisable(GL_DEPTH_TEST);

  vtkShaderProgram* program =
    window->GetShaderCache()->ReadyShaderProgram(FullScreenTriangleVS, HiZFS, "");
  if (program)
  {
    depths->Activate();
    program->SetUniformi("depths", depths->GetTextureUnit());
    program->SetUniformi("tileSize", tileSize);
    this->Reduction.VAO->Bind();
    glDrawArrays(GL_TRIANGLES, 0, 3);
    this->Reduction.VAO->Release();
    depths->Deactivate();
  }
  state->PopFramebufferBindings();
}

//------------------------------------------------------------------------------
void HiZBuffer::Activate(vtkShaderProgram* program)
{
  this->FarthestDepths->Activate();
  program->SetUniformi("hiZ", this->FarthestDepths->GetTextureUnit());
}

//------------------------------------------------------------------------------
void HiZBuffer::Deactivate()
{
  this->FarthestDepths->Deactivate();
}

//------------------------------------------------------------------------------
void HiZBuffer::ReleaseGraphicsResources(vtkWindow* window)
{
  this->Framebuffer->ReleaseGraphicsResources(window);
  this->FarthestDepths->ReleaseGraphicsResources(window);
  this->Reduction.ReleaseGraphicsResources(window);
}
}
