// SPDX-License-Identifier: BSD-3-Clause
#include "vtkSpherePackingPicturePass.h"

#include "vtkCamera.h"
#include "vtkFloatArray.h"
#include "vtkImageData.h"
#include "vtkObjectFactory.h"
#include "vtkOpenGLError.h"
#include "vtkOpenGLQuadHelper.h"
#include "vtkOpenGLRenderWindow.h"
#include "vtkOpenGLShaderCache.h"
#include "vtkOpenGLState.h"
#include "vtkPointData.h"
#include "vtkRenderState.h"
#include "vtkRenderer.h"
#include "vtkShaderProgram.h"
#include "vtkTextureObject.h"
#include "vtkUnsignedCharArray.h"
#include "vtk_glad.h"

#include "PictureFS.h"

#include <algorithm>

vtkStandardNewMacro(vtkSpherePackingPicturePass);

namespace
{
bool Load(vtkTextureObject* texture, vtkOpenGLRenderWindow* window, const int (&size)[2],
  int components, int type, void* values)
{
  texture->SetContext(window);
  return texture->Create2DFromRaw(static_cast<unsigned int>(size[0]),
    static_cast<unsigned int>(size[1]), components, type, values);
}
}

//------------------------------------------------------------------------------
vtkSpherePackingPicturePass::vtkSpherePackingPicturePass() = default;
vtkSpherePackingPicturePass::~vtkSpherePackingPicturePass() = default;

//------------------------------------------------------------------------------
void vtkSpherePackingPicturePass::SetPicture(vtkImageData* picture)
{
  if (this->Picture != picture)
  {
    this->Picture = picture;
    this->UploadTime = vtkTimeStamp();
    this->Modified();
  }
}

//------------------------------------------------------------------------------
vtkImageData* vtkSpherePackingPicturePass::GetPicture()
{
  return this->Picture;
}

//------------------------------------------------------------------------------
bool vtkSpherePackingPicturePass::Upload(vtkOpenGLRenderWindow* window)
{
  vtkPointData* data = this->Picture->GetPointData();
  auto* color = vtkUnsignedCharArray::SafeDownCast(data->GetArray("color"));
  auto* depth = vtkFloatArray::SafeDownCast(data->GetArray("depth"));
  if (!color || color->GetNumberOfComponents() != 4 || !depth ||
    depth->GetNumberOfComponents() != 1)
  {
    return false;
  }
  if (this->Colors->GetHandle() && this->UploadTime > this->Picture->GetMTime())
  {
    return true;
  }
  const int size[2] = { this->Picture->GetDimensions()[0], this->Picture->GetDimensions()[1] };
  if (!Load(this->Colors, window, size, 4, VTK_UNSIGNED_CHAR, color->GetVoidPointer(0)) ||
    !Load(this->Depths, window, size, 1, VTK_FLOAT, depth->GetVoidPointer(0)))
  {
    vtkErrorMacro(
      "the picture of " << size[0] << " x " << size[1] << " pixels cannot be made a texture");
    return false;
  }
  this->UploadTime.Modified();
  return true;
}

//------------------------------------------------------------------------------
bool vtkSpherePackingPicturePass::UseProgram(vtkOpenGLRenderWindow* window)
{
  if (!this->Quad)
  {
    this->Quad.reset(new vtkOpenGLQuadHelper(window, nullptr, PictureFS, nullptr));
  }
  else
  {
    window->GetShaderCache()->ReadyShaderProgram(this->Quad->Program);
  }
  return this->Quad->Program != nullptr;
}

//------------------------------------------------------------------------------
void vtkSpherePackingPicturePass::SetUniforms(vtkRenderer* renderer, vtkOpenGLRenderWindow* window)
{
  vtkCamera* camera = renderer->GetActiveCamera();
  float range[2];
  for (int i = 0; i < 2; ++i)
  {
    range[i] = static_cast<float>(camera->GetClippingRange()[i]);
  }
  // vtkWindowToImageFilter makes images larger than the window of tiles.
  const double* viewport = renderer->GetViewport();
  const double* tile = window->GetTileViewport();
  float origin[2];
  float size[2];
  for (int i = 0; i < 2; ++i)
  {
    const double whole = viewport[i + 2] - viewport[i];
    const double low = std::max(viewport[i], tile[i]);
    origin[i] = static_cast<float>((low - viewport[i]) / whole);
    size[i] = static_cast<float>((std::min(viewport[i + 2], tile[i + 2]) - low) / whole);
  }
  vtkShaderProgram* program = this->Quad->Program;
  program->SetUniform2f("tileOrigin", origin);
  program->SetUniform2f("tileSize", size);
  program->SetUniformi("colors", this->Colors->GetTextureUnit());
  program->SetUniformi("depths", this->Depths->GetTextureUnit());
  program->SetUniform2f("clippingRange", range);
  program->SetUniformi("parallelProjection", camera->GetParallelProjection());
}

//------------------------------------------------------------------------------
void vtkSpherePackingPicturePass::Render(const vtkRenderState* s)
{
  this->NumberOfRenderedProps = 0;
  vtkRenderer* renderer = s->GetRenderer();
  auto* window = vtkOpenGLRenderWindow::SafeDownCast(renderer->GetRenderWindow());
  if (!this->Picture || !window || !this->Upload(window))
  {
    return;
  }
  vtkOpenGLState* state = window->GetState();
  vtkOpenGLState::ScopedglDepthMask depthMask(state);
  vtkOpenGLState::ScopedglDepthFunc depthFunction(state);
  vtkOpenGLState::ScopedglBlendFuncSeparate blending(state);
  vtkOpenGLState::ScopedglEnableDisable blend(state, GL_BLEND);
  vtkOpenGLState::ScopedglEnableDisable test(state, GL_DEPTH_TEST);
  state->vtkglDepthMask(GL_TRUE);
  state->vtkglDepthFunc(GL_LEQUAL);
  state->vtkglEnable(GL_DEPTH_TEST);
  state->vtkglEnable(GL_BLEND);
  state->vtkglBlendFuncSeparate(
    GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA, GL_ONE, GL_ONE_MINUS_SRC_ALPHA);

  if (!this->UseProgram(window))
  {
    return;
  }
  this->Colors->Activate();
  this->Depths->Activate();
  this->SetUniforms(renderer, window);
  this->Quad->Render();
  this->Depths->Deactivate();
  this->Colors->Deactivate();
  this->NumberOfRenderedProps = 1;
  vtkOpenGLCheckErrorMacro("failed after drawing the picture");
}

//------------------------------------------------------------------------------
void vtkSpherePackingPicturePass::ReleaseGraphicsResources(vtkWindow* window)
{
  this->Quad.reset();
  this->Colors->ReleaseGraphicsResources(window);
  this->Depths->ReleaseGraphicsResources(window);
  this->Superclass::ReleaseGraphicsResources(window);
}

//------------------------------------------------------------------------------
void vtkSpherePackingPicturePass::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Picture: " << this->Picture.Get() << "\n";
}
