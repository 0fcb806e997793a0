// SPDX-License-Identifier: BSD-3-Clause
#include "vtkSpherePackingWindowCheck.h"

#include "vtkObjectFactory.h"
#include "vtkOpenGLFramebufferObject.h"
#include "vtkOpenGLRenderWindow.h"
#include "vtkOpenGLState.h"
#include "vtkOutputWindow.h"
#include "vtk_glad.h"

#include <algorithm>
#include <cctype>

vtkStandardNewMacro(vtkSpherePackingWindowCheck);

namespace
{
// OpenGL keeps one error of each kind; the number only ends a loop where there is no context.
constexpr int MaxErrors = 16;

// What OpenGL reports, as a phrase; takes it.
std::string ErrorOf(vtkOpenGLRenderWindow* window)
{
  std::string found;
  if (window && window->GetInitialized())
  {
    window->MakeCurrent();
    GLenum error = glGetError();
    for (int i = 0; i < MaxErrors && error != GL_NO_ERROR; ++i)
    {
      found = error == GL_OUT_OF_MEMORY             ? "OpenGL has too little memory"
        : error == GL_INVALID_FRAMEBUFFER_OPERATION ? "OpenGL has no such framebuffer"
                                                    : found;
      error = glGetError();
    }
  }
  return found;
}

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
vtkSpherePackingWindowCheck::vtkSpherePackingWindowCheck() = default;

//------------------------------------------------------------------------------
vtkSpherePackingWindowCheck::~vtkSpherePackingWindowCheck()
{
  this->StopListening();
}

//------------------------------------------------------------------------------
void vtkSpherePackingWindowCheck::Begin(vtkRenderWindow* window)
{
  this->StopListening();
  this->Window = window;
  this->Logged.clear();
  ErrorOf(vtkOpenGLRenderWindow::SafeDownCast(window));
  this->Log = vtkOutputWindow::GetInstance();
  this->Tag =
    this->Log->AddObserver(vtkCommand::ErrorEvent, this, &vtkSpherePackingWindowCheck::Hear);
}

//------------------------------------------------------------------------------
std::string vtkSpherePackingWindowCheck::End()
{
  this->StopListening();
  auto* window = vtkOpenGLRenderWindow::SafeDownCast(this->Window);
  const std::string error = ErrorOf(window);
  const bool complete = !window || !window->GetInitialized() ||
    (IsComplete(window, window->GetRenderFramebuffer()) &&
      IsComplete(window, window->GetDisplayFramebuffer()));
  this->Window = nullptr;
  return !error.empty() ? error
    : complete          ? this->Logged
                        : "OpenGL has no framebuffer of that size";
}

//------------------------------------------------------------------------------
void vtkSpherePackingWindowCheck::Hear(vtkObject*, unsigned long, void* text)
{
  std::string lower = text ? static_cast<const char*>(text) : "";
  std::transform(lower.begin(), lower.end(), lower.begin(),
    [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  const bool about =
    lower.find("framebuffer") != lower.npos || lower.find("frame buffer") != lower.npos;
  if (about && this->Logged.empty())
  {
    this->Logged = "VTK has no framebuffer for a part of it";
  }
}

//------------------------------------------------------------------------------
void vtkSpherePackingWindowCheck::StopListening()
{
  if (this->Log)
  {
    this->Log->RemoveObserver(this->Tag);
    this->Log = nullptr;
  }
}
