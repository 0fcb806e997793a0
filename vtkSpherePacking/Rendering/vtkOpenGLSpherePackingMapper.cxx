// SPDX-License-Identifier: BSD-3-Clause
#include "vtkOpenGLSpherePackingMapper.h"

#include "vtkOpenGLSpherePackingMapperInternals.h"

#include "vtkActor.h"
#include "vtkAlgorithm.h"
#include "vtkCommand.h"
#include "vtkHardwareSelector.h"
#include "vtkInformation.h"
#include "vtkMath.h"
#include "vtkObjectFactory.h"
#include "vtkOpenGLError.h"
#include "vtkOpenGLIndexBufferObject.h"
#include "vtkOpenGLResourceFreeCallback.h"
#include "vtkOpenGLRenderPass.h"
#include "vtkOpenGLRenderWindow.h"
#include "vtkOpenGLRenderer.h"
#include "vtkOpenGLState.h"
#include "vtkOpenGLVertexArrayObject.h"
#include "vtkPolyData.h"
#include "vtkProperty.h"
#include "vtkRenderer.h"
#include "vtk_glad.h"

#include <algorithm>

vtkStandardNewMacro(vtkOpenGLSpherePackingMapper);

namespace
{
// Beyond this a point's square wastes more fragments than the quad's set-up costs.
constexpr float LargestUsefulPoint = 255.0f;

// A window that cannot go back to the context before, as OSMesa's, leaves another one current when
// it releases what it held, and what VTK then sets arrives there. So what the state believes of
// the viewport may not hold any more. (VTK's own mappers draw with what is there.)
void RestoreViewport(vtkOpenGLState* state)
{
  int viewport[4];
  int scissor[4];
  state->vtkglGetIntegerv(GL_VIEWPORT, viewport);
  state->vtkglGetIntegerv(GL_SCISSOR_BOX, scissor);
  state->ResetGLViewportState();
  state->ResetGLScissorState();
  state->vtkglViewport(viewport[0], viewport[1], viewport[2], viewport[3]);
  state->vtkglScissor(scissor[0], scissor[1], scissor[2], scissor[3]);
}
}

//------------------------------------------------------------------------------
vtkOpenGLSpherePackingMapper::vtkOpenGLSpherePackingMapper()
  : Impl(new Internals)
{
  this->SetRadiusArrayName("radius");
  this->InterpolateScalarsBeforeMapping = 0;
  this->Impl->Screen.PrimitiveType = PrimitiveTris;
}

//------------------------------------------------------------------------------
vtkOpenGLSpherePackingMapper::~vtkOpenGLSpherePackingMapper()
{
  this->SetRadiusArrayName(nullptr);
}

//------------------------------------------------------------------------------
const char* vtkOpenGLSpherePackingMapper::GetErrorMessage() const
{
  return this->Impl->ErrorMessage.c_str();
}

//------------------------------------------------------------------------------
void vtkOpenGLSpherePackingMapper::Fail(const std::string& message)
{
  // Once a cause, not once a frame.
  if (message != this->Impl->ErrorMessage)
  {
    this->Impl->ErrorMessage = message;
    vtkErrorMacro(<< message);
  }
}

//------------------------------------------------------------------------------
bool vtkOpenGLSpherePackingMapper::PrepareInput()
{
  Internals& impl = *this->Impl;
  vtkPolyData* input = this->CurrentInput;
  if (impl.CheckedInput == input && impl.CheckTime > input->GetMTime() &&
    impl.CheckTime > this->GetMTime())
  {
    return impl.Radii != nullptr;
  }
  impl.Radii = impl.Input->FindRadii(input, this->RadiusArrayName);
  impl.CheckedInput = input;
  impl.CheckTime.Modified();
  if (*impl.Input->GetMessage())
  {
    this->Fail(impl.Input->GetMessage());
  }
  else
  {
    impl.ErrorMessage.clear();
  }
  return impl.Radii != nullptr;
}

//------------------------------------------------------------------------------
void vtkOpenGLSpherePackingMapper::ComputeBounds()
{
  vtkMath::UninitializeBounds(this->Bounds);
  this->CurrentInput = this->GetInput();
  if (this->CurrentInput && this->PrepareInput())
  {
    vtkSpherePackingInput::ComputeBounds(this->CurrentInput, this->Impl->Radii, this->Bounds);
  }
}

//------------------------------------------------------------------------------
void vtkOpenGLSpherePackingMapper::RenderPiece(vtkRenderer* ren, vtkActor* act)
{
  if (ren->GetRenderWindow()->CheckAbortStatus())
  {
    return;
  }
  auto* window = static_cast<vtkOpenGLRenderWindow*>(ren->GetRenderWindow());
  if (!this->ResourceCallback->IsWindowRegistered(window))
  {
    this->ResourceCallback->RegisterGraphicsResources(window);
    // The one whose resources have been released may be current. It cannot be asked, since an EGL
    // window always says that it is.
    window->MakeCurrent();
  }
  RestoreViewport(window->GetState());
  this->CurrentInput = this->GetInput();
  if (!this->CurrentInput)
  {
    vtkErrorMacro("No input!");
    return;
  }
  this->InvokeEvent(vtkCommand::StartEvent, nullptr);
  if (!this->Static)
  {
    this->GetInputAlgorithm()->Update();
  }
  this->InvokeEvent(vtkCommand::EndEvent, nullptr);
  if (this->PrepareInput() && (this->Drawn || ren->GetSelector()))
  {
    this->RenderPieceStart(ren, act);
    this->RenderPieceDraw(ren, act);
    this->RenderPieceFinish(ren, act);
  }
}

//------------------------------------------------------------------------------
void vtkOpenGLSpherePackingMapper::RenderPieceStart(vtkRenderer* ren, vtkActor* act)
{
  this->Superclass::RenderPieceStart(ren, act);
  vtkHardwareSelector* selector = ren->GetSelector();
  if (selector && selector->GetFieldAssociation() == vtkDataObject::FIELD_ASSOCIATION_POINTS)
  {
    // VTK picks points against the depth of the last picture. Spheres hide each other, so these
    // write depth as always.
    static_cast<vtkOpenGLRenderWindow*>(ren->GetRenderWindow())
      ->GetState()
      ->vtkglDepthMask(GL_TRUE);
  }
}

//------------------------------------------------------------------------------
void vtkOpenGLSpherePackingMapper::BuildBufferObjects(vtkRenderer*, vtkActor*)
{
  this->MapScalars(1.0);
  Internals& impl = *this->Impl;
  impl.HasColors =
    this->Colors && this->Colors->GetNumberOfTuples() == this->CurrentInput->GetNumberOfPoints();
  const std::vector<vtkSpherePackingVertex> vertices =
    impl.Vertices.Build(this->CurrentInput, impl.Radii, impl.HasColors ? this->Colors : nullptr);
  impl.NumberOfVertices = static_cast<vtkIdType>(vertices.size());
  impl.VertexBuffer->Upload(vertices, vtkOpenGLBufferObject::ArrayBuffer);
  impl.IdsUploaded = false;
  impl.BufferTime.Modified();
  this->VBOBuildTime.Modified();
}

//------------------------------------------------------------------------------
void vtkOpenGLSpherePackingMapper::RenderPieceDraw(vtkRenderer* ren, vtkActor* act)
{
  Internals& impl = *this->Impl;
  const std::string problem = impl.View.Compute(ren, act, impl.Vertices.GetOrigin());
  if (!problem.empty())
  {
    this->Fail(problem);
    return;
  }
  impl.ErrorMessage.clear();
  GLfloat range[2] = { 1.0f, 1.0f };
  glGetFloatv(GL_POINT_SIZE_RANGE, range);
  impl.MaximumPointSize = std::min(range[1], LargestUsefulPoint);
  const bool translucent = act->IsRenderingTranslucentPolygonalGeometry() != 0;
  const bool selecting = ren->GetSelector() != nullptr;
  const bool bothSides = translucent && !selecting && !act->GetProperty()->GetBackfaceCulling();
  impl.MayBeCut = bothSides || this->GetNumberOfClippingPlanes() > 0 ||
    !impl.View.HoldsDepthsOf(this->Bounds, impl.Vertices.GetOrigin());
  vtkInformation* keys = act->GetPropertyKeys();
  const bool renderPasses = keys && keys->Has(vtkOpenGLRenderPass::RenderPasses());
  // Surfaces first pay off against an extra pass when there are many spheres, several lights, or
  // several samples a pixel, none of which a sphere's silhouette uses.
  const bool costly = impl.NumberOfVertices > 20000 ||
    ren->GetRenderWindow()->GetMultiSamples() > 1 ||
    static_cast<vtkOpenGLRenderer*>(ren)->GetLightingComplexity() > 1;
  if (costly && !translucent && !selecting && !renderPasses)
  {
    this->DrawSurfacesThenLights(ren, act);
    return;
  }
  if (selecting && !impl.IdsUploaded)
  {
    impl.UploadIds();
  }
  this->UploadQuads(impl.View);
  impl.HitMode = bothSides ? Internals::FarHit : Internals::FirstHit;
  this->DrawSpheres(ren, act);
  if (bothSides)
  {
    impl.HitMode = Internals::NearHit;
    this->DrawSpheres(ren, act);
  }
}

//------------------------------------------------------------------------------
void vtkOpenGLSpherePackingMapper::UploadQuads(const vtkSpherePackingView& view)
{
  Internals& impl = *this->Impl;
  const std::vector<vtkSpherePackingQuadVertex> quads =
    vtkSpherePackingMakeQuads(this->CurrentInput, impl.Radii,
      impl.HasColors ? this->Colors : nullptr, impl.Vertices, view, impl.MaximumPointSize);
  impl.NumberOfQuadVertices = static_cast<vtkIdType>(quads.size());
  if (!quads.empty())
  {
    impl.QuadBuffer->Upload(quads, vtkOpenGLBufferObject::ArrayBuffer);
  }
}

//------------------------------------------------------------------------------
void vtkOpenGLSpherePackingMapper::DrawSpheres(vtkRenderer* ren, vtkActor* act)
{
  Internals& impl = *this->Impl;
  vtkOpenGLState* state = static_cast<vtkOpenGLRenderWindow*>(ren->GetRenderWindow())->GetState();
  vtkOpenGLState::ScopedglEnableDisable pointSize(state, GL_PROGRAM_POINT_SIZE);
  vtkOpenGLState::ScopedglEnableDisable cull(state, GL_CULL_FACE);
  state->vtkglEnable(GL_PROGRAM_POINT_SIZE);
  state->vtkglDisable(GL_CULL_FACE);
  this->UpdateShaders(this->Primitives[PrimitiveTris], ren, act);
  glDrawArrays(GL_POINTS, 0, static_cast<GLsizei>(impl.NumberOfVertices));
  if (impl.NumberOfQuadVertices > 0)
  {
    this->UpdateShaders(this->Primitives[PrimitiveTriStrips], ren, act);
    glDrawArrays(GL_TRIANGLES, 0, static_cast<GLsizei>(impl.NumberOfQuadVertices));
  }
  vtkOpenGLCheckErrorMacro("failed after drawing spheres");
}

//------------------------------------------------------------------------------
void vtkOpenGLSpherePackingMapper::DrawSurfacesThenLights(vtkRenderer* ren, vtkActor* act)
{
  Internals& impl = *this->Impl;
  auto* window = static_cast<vtkOpenGLRenderWindow*>(ren->GetRenderWindow());
  vtkSpherePackingSurfaces::Scene scene;
  scene.View = impl.View;
  scene.View.Viewport[0] = 0.0; // the textures are as large as the viewport
  scene.View.Viewport[1] = 0.0;
  this->UploadQuads(scene.View);
  scene.Features = impl.GetFeatures(this->GetNumberOfClippingPlanes());
  scene.ClippingPlanes = this->ComputeClippingPlanes(act);
  scene.MaximumPointSize = impl.MaximumPointSize;
  scene.Vertices = impl.VertexBuffer;
  scene.Phases = vtkSpherePackingMakePhases(impl.Vertices, scene.View);
  scene.OccluderTile =
    scene.View.ChooseTile(this->Bounds, impl.Vertices.GetOrigin(), impl.Vertices.GetUsualRadius());
  scene.Quads = impl.QuadBuffer;
  scene.NumberOfQuadVertices = static_cast<int>(impl.NumberOfQuadVertices);
  scene.BufferTime = impl.BufferTime;
  impl.Surfaces->Draw(window, scene);

  vtkOpenGLState::ScopedglEnableDisable cull(window->GetState(), GL_CULL_FACE);
  window->GetState()->vtkglDisable(GL_CULL_FACE);
  this->UpdateShaders(impl.Screen, ren, act);
  glDrawArrays(GL_TRIANGLES, 0, 3);
  impl.Surfaces->Deactivate();
  vtkOpenGLCheckErrorMacro("failed after lighting spheres");
}

//------------------------------------------------------------------------------
std::vector<std::array<float, 4>> vtkOpenGLSpherePackingMapper::ComputeClippingPlanes(vtkActor* act)
{
  std::vector<std::array<float, 4>> planes(this->GetNumberOfClippingPlanes());
  for (std::size_t i = 0; i < planes.size(); ++i)
  {
    double plane[4];
    this->GetClippingPlaneInDataCoords(act->GetMatrix(), static_cast<int>(i), plane);
    planes[i] = this->Impl->View.ToNearPlaneSpace(plane, this->Impl->Vertices.GetOrigin());
  }
  return planes;
}

//------------------------------------------------------------------------------
bool vtkOpenGLSpherePackingMapper::DrawingQuads() const
{
  return this->LastBoundBO == &this->Primitives[PrimitiveTriStrips];
}

//------------------------------------------------------------------------------
bool vtkOpenGLSpherePackingMapper::DrawingScreen() const
{
  return this->LastBoundBO == &this->Impl->Screen;
}

//------------------------------------------------------------------------------
void vtkOpenGLSpherePackingMapper::UpdateMaximumPointCellIds(vtkRenderer* ren, vtkActor*)
{
  const vtkIdType last = this->CurrentInput->GetNumberOfPoints() - 1;
  ren->GetSelector()->UpdateMaximumPointId(last);
  ren->GetSelector()->UpdateMaximumCellId(last);
}

//------------------------------------------------------------------------------
void vtkOpenGLSpherePackingMapper::ProcessSelectorPixelBuffers(
  vtkHardwareSelector* selector, std::vector<unsigned int>& offsets, vtkProp* prop)
{
  // The shader wrote the sphere's id for cells too; the superclass would look it up in the cells.
  const int pass = selector->GetCurrentPass();
  if (pass != vtkHardwareSelector::CELL_ID_LOW24 && pass != vtkHardwareSelector::CELL_ID_HIGH24)
  {
    this->Superclass::ProcessSelectorPixelBuffers(selector, offsets, prop);
  }
}

//------------------------------------------------------------------------------
void vtkOpenGLSpherePackingMapper::ReleaseGraphicsResources(vtkWindow* window)
{
  if (!this->ResourceCallback->IsReleasing())
  {
    // What another window holds goes with that one. Its context would stay current here, and what
    // else this window releases would be taken from it.
    if (!window ||
      this->ResourceCallback->IsWindowRegistered(static_cast<vtkOpenGLRenderWindow*>(window)))
    {
      this->ResourceCallback->Release(); // comes back here in the context that holds them
    }
    return;
  }
  this->Impl->VertexBuffer->ReleaseGraphicsResources();
  this->Impl->IdBuffer->ReleaseGraphicsResources();
  this->Impl->QuadBuffer->ReleaseGraphicsResources();
  this->Impl->Surfaces->ReleaseGraphicsResources(window);
  this->Impl->Surfaces.reset(new vtkSpherePackingSurfaces);
  this->Impl->Screen.ReleaseGraphicsResources(window);
  this->Superclass::ReleaseGraphicsResources(window);
}

//------------------------------------------------------------------------------
void vtkOpenGLSpherePackingMapper::ShallowCopy(vtkAbstractMapper* mapper)
{
  if (auto* other = vtkOpenGLSpherePackingMapper::SafeDownCast(mapper))
  {
    this->SetRadiusArrayName(other->GetRadiusArrayName());
  }
  this->Superclass::ShallowCopy(mapper);
}

//------------------------------------------------------------------------------
void vtkOpenGLSpherePackingMapper::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "RadiusArrayName: " << (this->RadiusArrayName ? this->RadiusArrayName : "(none)")
     << "\n";
}
