// SPDX-License-Identifier: BSD-3-Clause
#include "vtkSpherePackingWindowCheck.h"

#include "vtkObjectFactory.h"
#include "vtkOpenGLFramebufferObject.h"
#include "vtkOpenGLRenderWindow.h"
#include "vtkOpenGLState.h"
#include "vtk_glad.h"

#include <algorithm>

vtkStandardNewMacro(vtkSpherePackingWindowCheck);

namespace
{
// OpenGL keeps one error of each kind; the number only ends a loop where there is no context.
constexpr int MaxErrors = 16;

bool IsComplete(vtkOpenGLRenderWindow* window, vtkOpenGLFramebufferObject* framebuffer)
{
  vtkOpenGLState* state = window->GetState();
  state->PushFramebufferBindings();
  framebuffer->Bind();
  const bool complete = glCheckFramebufferStatus(GL_FRAMEBUFFER) == GL_FRAMEBUFFER_COMPLETE;
  state->PopFramebufferBindings();
  return complete;
}
}

//------------------------------------------------------------------------------
int vtkSpherePackingWindowCheck::GetLargestSide(vtkRenderWindow* window)
{
  auto* opengl = vtkOpenGLRenderWindow::SafeDownCast(window);
  if (!opengl)
  {
    return 0;
  }
  opengl->Initialize();
  opengl->MakeCurrent();
  int texture = 0;
  int renderbuffer = 0;
  int viewport[2] = {};
  vtkOpenGLState* state = opengl->GetState();
  state->vtkglGetIntegerv(GL_MAX_TEXTURE_SIZE, &texture);
  state->vtkglGetIntegerv(GL_MAX_RENDERBUFFER_SIZE, &renderbuffer);
  state->vtkglGetIntegerv(GL_MAX_VIEWPORT_DIMS, viewport);
  return std::min({ texture, renderbuffer, viewport[0], viewport[1] });
}

//------------------------------------------------------------------------------
std::string vtkSpherePackingWindowCheck::FindProblem(vtkRenderWindow* window)
{
  auto* opengl = vtkOpenGLRenderWindow::SafeDownCast(window);
  if (!opengl || !opengl->GetInitialized())
  {
    return {};
  }
  opengl->MakeCurrent();
  for (int i = 0; i < MaxErrors; ++i)
  {
    const GLenum error = glGetError();
    if (error == GL_OUT_OF_MEMORY)
    {
      return "OpenGL has too little memory";
    }
    if (error == GL_INVALID_FRAMEBUFFER_OPERATION)
    {
      return "OpenGL has no such framebuffer";
    }
    if (error == GL_NO_ERROR)
    {
      break;
    }
  }
  if (!IsComplete(opengl, opengl->GetRenderFramebuffer()) ||
    !IsComplete(opengl, opengl->GetDisplayFramebuffer()))
  {
    return "OpenGL has no framebuffer of that size";
  }
  return {};
}
