// SPDX-License-Identifier: BSD-3-Clause
#include "vtkOpenGLSpherePackingMapper.h"

#include "impostor/GBuffer.h"
#include "impostor/ImpostorBuffers.h"
#include "impostor/RestoreViewport.h"
#include "impostor/ShaderReplacements.h"

#include "vtkActor.h"
#include "vtkAlgorithm.h"
#include "vtkCommand.h"
#include "vtkHardwareSelector.h"
#include "vtkInformation.h"
#include "vtkMath.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkOpenGLError.h"
#include "vtkOpenGLRenderPass.h"
#include "vtkOpenGLRenderWindow.h"
#include "vtkOpenGLRenderer.h"
#include "vtkOpenGLResourceFreeCallback.h"
#include "vtkOpenGLState.h"
#include "vtkOpenGLVertexArrayObject.h"
#include "vtkPolyData.h"
#include "vtkProperty.h"
#include "vtkRenderer.h"
#include "vtkShaderProgram.h"
#include "vtkSpherePackingInput.h"
#include "vtk_glad.h"

#include <algorithm>
#include <array>
#include <new>
#include <string>
#include <vector>

using spherepacking::AdaptLights;
using spherepacking::GBuffer;
using spherepacking::ImpostorBuffers;
using spherepacking::ManySpheres;
using spherepacking::PointSprites;
using spherepacking::ProgramKind;
using spherepacking::ReplacePicking;
using spherepacking::RestoreViewport;
using spherepacking::ShaderVariant;
using spherepacking::ViewTransform;

vtkStandardNewMacro(vtkOpenGLSpherePackingMapper);

struct vtkOpenGLSpherePackingMapper::Internals
{
  // As `hitMode` in RaySphereFS.glsl.
  enum HitModes
  {
    FirstHit = 0,
    NearHit = 1,
    FarHit = 2
  };

  vtkNew<vtkSpherePackingInput> Input;
  vtkPolyData* CheckedInput = nullptr; // only compared, never dereferenced
  vtkTimeStamp CheckTime;
  vtkDataArray* Radii = nullptr; // of the input that was checked
  std::string ErrorMessage;

  ViewTransform View;
  ImpostorBuffers Buffers;
  ShaderVariant Variant;      // that this frame needs
  ShaderVariant BuiltVariant; // that VTK's programs were built for
  float MaximumPointSize = 1.0f;
  HitModes HitMode = FirstHit;

  GBuffer GeometryPass;
  vtkOpenGLHelper LightingPass;

  // The superclass's programs for PrimitiveTris draw the point sprites and those for
  // PrimitiveTriStrips the quads: without normals, VTK lights no other primitives.
  ProgramKind KindOf(const vtkOpenGLHelper& program) const
  {
    return &program == &this->LightingPass          ? ProgramKind::Lighting
      : program.PrimitiveType == PrimitiveTriStrips ? ProgramKind::Quads
                                                    : ProgramKind::PointSprites;
  }
};

namespace
{
// In pixels. The square of a larger point wastes more fragments than setting up a quad costs.
constexpr float LargestUsefulPoint = 255.0f;
}

//------------------------------------------------------------------------------
vtkOpenGLSpherePackingMapper::vtkOpenGLSpherePackingMapper()
  : Impl(new Internals)
{
  this->SetRadiusArrayName("radius");
  this->InterpolateScalarsBeforeMapping = 0;
  this->Impl->LightingPass.PrimitiveType = PrimitiveTris;
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
  // Reported once, not in every frame.
  if (message != this->Impl->ErrorMessage)
  {
    this->Impl->ErrorMessage = message;
    vtkErrorMacro(<< message);
  }
}

//------------------------------------------------------------------------------
template <typename Work>
void vtkOpenGLSpherePackingMapper::RunGuarded(const Work& work)
{
  // VTK's Python wrappers translate no exception, so it would end the process.
  try
  {
    try
    {
      work();
    }
    catch (const std::bad_alloc&)
    {
      this->Fail("the spheres do not fit in the memory that is free");
    }
  }
  catch (const std::bad_alloc&)
  {
    this->Impl->ErrorMessage = "out of memory"; // which the std::string holds itself
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
  this->RunGuarded(
    [&]
    {
      if (this->CurrentInput && this->PrepareInput())
      {
        vtkSpherePackingInput::ComputeBounds(this->CurrentInput, this->Impl->Radii, this->Bounds);
      }
    });
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
    // The window that had to release its resources for that may be current: see RestoreViewport().
    // Upstream: VTK 9.7: vtkEGLRenderWindow::IsCurrent() is always true, so it cannot be asked.
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
  this->RunGuarded(
    [&]
    {
      if (this->PrepareInput() && (this->Drawn || ren->GetSelector()))
      {
        this->RenderPieceStart(ren, act);
        this->RenderPieceDraw(ren, act);
        this->RenderPieceFinish(ren, act);
      }
    });
}

//------------------------------------------------------------------------------
void vtkOpenGLSpherePackingMapper::RenderPieceStart(vtkRenderer* ren, vtkActor* act)
{
  this->Superclass::RenderPieceStart(ren, act);
  vtkHardwareSelector* selector = ren->GetSelector();
  if (selector && selector->GetFieldAssociation() == vtkDataObject::FIELD_ASSOCIATION_POINTS)
  {
    // VTK 9.7 picks points, which do not hide each other, against the depths of the last frame and
    // turns writing depths off. Spheres hide each other.
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
  impl.Variant.Colors =
    this->Colors && this->Colors->GetNumberOfTuples() == this->CurrentInput->GetNumberOfPoints();
  impl.Buffers.UploadSprites(
    this->CurrentInput, impl.Radii, impl.Variant.Colors ? this->Colors : nullptr);
  this->VBOBuildTime.Modified();
}

//------------------------------------------------------------------------------
void vtkOpenGLSpherePackingMapper::RenderPieceDraw(vtkRenderer* ren, vtkActor* act)
{
  Internals& impl = *this->Impl;
  const std::array<double, 3>& origin = impl.Buffers.Sprites.GetOrigin();
  const std::string problem = impl.View.Compute(ren, act, origin);
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
  const bool bothHits = translucent && !selecting && !act->GetProperty()->GetBackfaceCulling();
  impl.Variant.Parallel = impl.View.Parallel;
  impl.Variant.ClippingPlanes = this->GetNumberOfClippingPlanes();
  impl.Variant.MayBeCut = bothHits || impl.Variant.ClippingPlanes > 0 ||
    !impl.View.DepthRangeContains(this->Bounds, origin);
  vtkInformation* keys = act->GetPropertyKeys();
  const bool renderPasses = keys && keys->Has(vtkOpenGLRenderPass::RenderPasses());
  // Deferred shading costs a pass over the window. It pays with many spheres, several lights, or
  // several samples per pixel, none of which a sphere's silhouette uses.
  const bool costly = impl.Buffers.NumberOfSprites > ManySpheres ||
    ren->GetRenderWindow()->GetMultiSamples() > 1 ||
    static_cast<vtkOpenGLRenderer*>(ren)->GetLightingComplexity() > 1;
  if (costly && !translucent && !selecting && !renderPasses)
  {
    this->DrawDeferred(ren, act);
    return;
  }
  if (selecting)
  {
    impl.Buffers.UploadIds();
  }
  impl.Buffers.UploadQuads(this->CurrentInput, impl.Radii,
    impl.Variant.Colors ? this->Colors : nullptr, impl.View, impl.MaximumPointSize);
  impl.HitMode = bothHits ? Internals::FarHit : Internals::FirstHit;
  this->DrawForward(ren, act);
  if (bothHits)
  {
    impl.HitMode = Internals::NearHit;
    this->DrawForward(ren, act);
  }
}

//------------------------------------------------------------------------------
void vtkOpenGLSpherePackingMapper::DrawForward(vtkRenderer* ren, vtkActor* act)
{
  const ImpostorBuffers& buffers = this->Impl->Buffers;
  vtkOpenGLState* state = static_cast<vtkOpenGLRenderWindow*>(ren->GetRenderWindow())->GetState();
  vtkOpenGLState::ScopedglEnableDisable pointSize(state, GL_PROGRAM_POINT_SIZE);
  vtkOpenGLState::ScopedglEnableDisable cull(state, GL_CULL_FACE);
  state->vtkglEnable(GL_PROGRAM_POINT_SIZE);
  state->vtkglDisable(GL_CULL_FACE);
  this->UpdateShaders(this->Primitives[PrimitiveTris], ren, act);
  glDrawArrays(GL_POINTS, 0, static_cast<GLsizei>(buffers.NumberOfSprites));
  if (buffers.NumberOfQuadVertices > 0)
  {
    this->UpdateShaders(this->Primitives[PrimitiveTriStrips], ren, act);
    glDrawArrays(GL_TRIANGLES, 0, static_cast<GLsizei>(buffers.NumberOfQuadVertices));
  }
  vtkOpenGLCheckErrorMacro("failed after drawing spheres");
}

//------------------------------------------------------------------------------
void vtkOpenGLSpherePackingMapper::DrawDeferred(vtkRenderer* ren, vtkActor* act)
{
  Internals& impl = *this->Impl;
  const PointSprites& sprites = impl.Buffers.Sprites;
  auto* window = static_cast<vtkOpenGLRenderWindow*>(ren->GetRenderWindow());
  GBuffer::FrameData frame;
  frame.View = impl.View;
  frame.View.Viewport[0] = 0.0; // the G-buffer is as large as the viewport
  frame.View.Viewport[1] = 0.0;
  impl.Buffers.UploadQuads(this->CurrentInput, impl.Radii,
    impl.Variant.Colors ? this->Colors : nullptr, frame.View, impl.MaximumPointSize);
  frame.Variant = impl.Variant;
  frame.ClippingPlanes = impl.View.ClippingPlanes(this, act, sprites.GetOrigin());
  frame.Buffers = &impl.Buffers;
  frame.Batches = MakeDrawOrder(sprites, frame.View);
  frame.MaximumPointSize = impl.MaximumPointSize;
  frame.HiZTileSize =
    HiZTileSize(frame.View, this->Bounds, sprites.GetOrigin(), sprites.GetUpperQuartileRadius());
  impl.GeometryPass.Draw(window, frame);

  vtkOpenGLState::ScopedglEnableDisable cull(window->GetState(), GL_CULL_FACE);
  window->GetState()->vtkglDisable(GL_CULL_FACE);
  this->UpdateShaders(impl.LightingPass, ren, act);
  glDrawArrays(GL_TRIANGLES, 0, 3);
  impl.GeometryPass.Deactivate();
  vtkOpenGLCheckErrorMacro("failed after lighting spheres");
}

//------------------------------------------------------------------------------
bool vtkOpenGLSpherePackingMapper::GetNeedToRebuildShaders(
  vtkOpenGLHelper& cellBO, vtkRenderer* ren, vtkActor* act)
{
  Internals& impl = *this->Impl;
  if (impl.Variant != impl.BuiltVariant)
  {
    impl.BuiltVariant = impl.Variant;
    // The superclass rebuilds every program that is older than this, not only the one asked for.
    this->SelectionStateChanged.Modified();
  }
  return this->Superclass::GetNeedToRebuildShaders(cellBO, ren, act);
}

//------------------------------------------------------------------------------
void vtkOpenGLSpherePackingMapper::GetShaderTemplate(
  std::map<vtkShader::Type, vtkShader*> shaders, vtkRenderer* ren, vtkActor* act)
{
  this->Superclass::GetShaderTemplate(shaders, ren, act);
  const Internals& impl = *this->Impl;
  ReplaceVertexShader(shaders, impl.KindOf(*this->LastBoundBO), impl.BuiltVariant.Colors);
}

//------------------------------------------------------------------------------
void vtkOpenGLSpherePackingMapper::ReplaceShaderPositionVC(
  std::map<vtkShader::Type, vtkShader*> shaders, vtkRenderer*, vtkActor*)
{
  const Internals& impl = *this->Impl;
  ReplacePosition(shaders, impl.BuiltVariant, impl.KindOf(*this->LastBoundBO));
}

//------------------------------------------------------------------------------
void vtkOpenGLSpherePackingMapper::ReplaceShaderNormal(
  std::map<vtkShader::Type, vtkShader*> shaders, vtkRenderer*, vtkActor*)
{
  ReplaceNormal(shaders, this->Impl->KindOf(*this->LastBoundBO));
}

//------------------------------------------------------------------------------
void vtkOpenGLSpherePackingMapper::ReplaceShaderLight(
  std::map<vtkShader::Type, vtkShader*> shaders, vtkRenderer* ren, vtkActor* act)
{
  this->Superclass::ReplaceShaderLight(shaders, ren, act);
  AdaptLights(shaders, act->GetProperty()->GetSpecular() != 0.0);
}

//------------------------------------------------------------------------------
void vtkOpenGLSpherePackingMapper::ReplaceShaderEdges(
  std::map<vtkShader::Type, vtkShader*> shaders, vtkRenderer*, vtkActor*)
{
  // The tags of edges, which spheres have not, come right after the superclass has declared the
  // colours of the material, which leaves no tag of its own.
  if (this->Impl->BuiltVariant.Colors)
  {
    ReplaceColor(shaders, this->Impl->KindOf(*this->LastBoundBO));
  }
}

//------------------------------------------------------------------------------
void vtkOpenGLSpherePackingMapper::ReplaceShaderClip(
  std::map<vtkShader::Type, vtkShader*>, vtkRenderer*, vtkActor*)
{
  // The planes clip the hit, not the primitive: isHitVisible() in RaySphereFS.glsl.
}

//------------------------------------------------------------------------------
void vtkOpenGLSpherePackingMapper::ReplaceShaderPicking(
  std::map<vtkShader::Type, vtkShader*> shaders, vtkRenderer* ren, vtkActor* act)
{
  if (!ReplacePicking(shaders, this->LastSelectionState))
  {
    this->Superclass::ReplaceShaderPicking(shaders, ren, act);
  }
}

//------------------------------------------------------------------------------
void vtkOpenGLSpherePackingMapper::ReplaceShaderCoincidentOffset(
  std::map<vtkShader::Type, vtkShader*>, vtkRenderer*, vtkActor*)
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
  const ProgramKind kind = impl.KindOf(cellBO);
  if (kind == ProgramKind::Lighting)
  {
    cellBO.VAO->Bind(); // without attributes, but drawing needs one
    impl.GeometryPass.Activate(program);
    const float origin[2] = { static_cast<float>(impl.View.Viewport[0]),
      static_cast<float>(impl.View.Viewport[1]) };
    program->SetUniform2f("viewportOrigin", origin);
    return;
  }
  if (impl.Buffers.BufferTime > cellBO.AttributeUpdateTime ||
    cellBO.ShaderSourceTime > cellBO.AttributeUpdateTime ||
    cellBO.VAO->GetMTime() > cellBO.AttributeUpdateTime.GetMTime())
  {
    impl.Buffers.AddAttributes(cellBO, kind);
    cellBO.AttributeUpdateTime.Modified();
  }
  program->SetUniformi("hitMode", impl.HitMode);
  // VTK 9.7 tests picks of points against the depths of the last frame; a step nearer they pass.
  program->SetUniformf("depthBias", ren->GetSelector() ? 5e-7f : 0.0f);
  const std::vector<std::array<float, 4>> planes =
    impl.View.ClippingPlanes(this, act, impl.Buffers.Sprites.GetOrigin());
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
  SetRayUniforms(program, impl.View);
  if (impl.KindOf(cellBO) == ProgramKind::PointSprites)
  {
    SetSpriteUniforms(program, impl.View, impl.MaximumPointSize);
  }
  else if (program->IsUniformUsed("cameraParallel"))
  {
    program->SetUniformi("cameraParallel", impl.View.Parallel ? 1 : 0);
  }
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
    // What another window holds goes with that one. Released now, its context would remain current
    // (see RestoreViewport()), and what else this window releases would be taken from it.
    if (!window ||
      this->ResourceCallback->IsWindowRegistered(static_cast<vtkOpenGLRenderWindow*>(window)))
    {
      this->ResourceCallback->Release(); // calls this again, in the context that holds them
    }
    return;
  }
  this->Impl->Buffers.ReleaseGraphicsResources();
  this->Impl->GeometryPass.ReleaseGraphicsResources(window);
  this->Impl->LightingPass.ReleaseGraphicsResources(window);
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
