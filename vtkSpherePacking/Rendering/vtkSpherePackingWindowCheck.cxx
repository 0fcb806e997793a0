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
#include <new>
#include <string_view>

vtkStandardNewMacro(vtkSpherePackingWindowCheck);

namespace
{
// OpenGL keeps one error of each kind; the number only ends a loop where there is no context.
constexpr int MaxErrors = 16;

// What OpenGL reports, as a phrase; takes it.
const char* ErrorOf(vtkOpenGLRenderWindow* window)
{
  const char* found = "";
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

// Whether a text has a word, whose letters are small, in letters of any size.
bool Holds(std::string_view text, std::string_view word)
{
  const auto same = [](char letter, char small)
  { return std::tolower(static_cast<unsigned char>(letter)) == small; };
  return std::search(text.begin(), text.end(), word.begin(), word.end(), same) != text.end();
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
  this->Logged = "";
  ErrorOf(vtkOpenGLRenderWindow::SafeDownCast(window));
  vtkOutputWindow* log = vtkOutputWindow::GetInstance();
  try
  {
    this->Tag = log->AddObserver(vtkCommand::ErrorEvent, this, &vtkSpherePackingWindowCheck::Hear);
    this->Log = log;
  }
  catch (const std::bad_alloc&)
  {
    this->Logged = "there is too little memory to watch it";
  }
}

//------------------------------------------------------------------------------
const char* vtkSpherePackingWindowCheck::End()
{
  this->StopListening();
  auto* window = vtkOpenGLRenderWindow::SafeDownCast(this->Window);
  const char* const error = ErrorOf(window);
  const bool complete = !window || !window->GetInitialized() ||
    (IsComplete(window, window->GetRenderFramebuffer()) &&
      IsComplete(window, window->GetDisplayFramebuffer()));
  this->Window = nullptr;
  return *error ? error : complete ? this->Logged : "OpenGL has no framebuffer of that size";
}

//------------------------------------------------------------------------------
void vtkSpherePackingWindowCheck::Hear(vtkObject*, unsigned long, void* text)
{
  const std::string_view said = text ? static_cast<const char*>(text) : "";
  const bool about = Holds(said, "framebuffer") || Holds(said, "frame buffer");
  if (about && !*this->Logged)
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
