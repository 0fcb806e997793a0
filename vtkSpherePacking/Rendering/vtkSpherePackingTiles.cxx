// SPDX-License-Identifier: BSD-3-Clause
#include "vtkSpherePackingTiles.h"

#include "tiles/TiledSupersampling.h"

#include "vtkCamera.h"
#include "vtkCollection.h"
#include "vtkMath.h"
#include "vtkMatrix4x4.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkOpenGLRenderWindow.h"
#include "vtkOpenGLState.h"
#include "vtkRenderer.h"
#include "vtkRendererCollection.h"
#include "vtkSmartPointer.h"
#include "vtk_glad.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

vtkStandardNewMacro(vtkSpherePackingTiles);

using spherepacking::TiledSupersampling;

namespace
{
// After all others, which then see the renderer's own camera.
constexpr float LastPriority = -1e30f;

// Pixels along one axis.
struct Span
{
  int Begin = 0;
  int End = 0;

  int Length() const { return this->End - this->Begin; }
};

using Area = std::array<Span, 2>;

// As vtkViewport rounds them.
Area AreaOf(const double viewport[4], const int size[2])
{
  Area area;
  for (int axis = 0; axis < 2; ++axis)
  {
    area[axis].Begin = static_cast<int>(viewport[axis] * size[axis] + 0.5);
    area[axis].End = static_cast<int>(viewport[axis + 2] * size[axis] + 0.5);
  }
  return area;
}

Area Overlap(const Area& a, const Area& b)
{
  Area both;
  for (int axis = 0; axis < 2; ++axis)
  {
    both[axis].Begin = std::clamp(b[axis].Begin, a[axis].Begin, a[axis].End);
    both[axis].End = std::clamp(b[axis].End, a[axis].Begin, a[axis].End);
  }
  return both;
}

// Narrows an explicit projection, which does not ask for angle and centre: device coordinates of
// the whole become those of the part.
void NarrowProjection(vtkMatrix4x4* projection, const double (&scale)[2], const double (&middle)[2])
{
  for (int axis = 0; axis < 2; ++axis)
  {
    for (int column = 0; column < 4; ++column)
    {
      const double moved =
        projection->GetElement(axis, column) - middle[axis] * projection->GetElement(3, column);
      projection->SetElement(axis, column, moved / scale[axis]);
    }
  }
}

// Lets a camera that sees `whole` see `part` of it.
void Narrow(vtkCamera* camera, const Area& whole, const Area& part)
{
  double scale[2];  // of the part
  double middle[2]; // of the part, from -1 to 1 over the whole
  double center[2];
  camera->GetWindowCenter(center);
  for (int axis = 0; axis < 2; ++axis)
  {
    const double length = whole[axis].Length();
    const double both = part[axis].Begin - whole[axis].Begin + part[axis].End - whole[axis].Begin;
    scale[axis] = part[axis].Length() / length;
    middle[axis] = both / length - 1.0;
    center[axis] = (center[axis] + middle[axis]) / scale[axis];
  }
  if (camera->GetUseExplicitProjectionTransformMatrix())
  {
    vtkNew<vtkMatrix4x4> projection;
    projection->DeepCopy(camera->GetExplicitProjectionTransformMatrix());
    NarrowProjection(projection, scale, middle);
    camera->SetExplicitProjectionTransformMatrix(projection);
    return;
  }
  const double angle = vtkMath::RadiansFromDegrees(camera->GetViewAngle());
  const double narrowing = scale[camera->GetUseHorizontalViewAngle() ? 0 : 1];
  camera->SetWindowCenter(center[0], center[1]);
  camera->SetViewAngle(
    vtkMath::DegreesFromRadians(2.0 * std::atan(std::tan(0.5 * angle) * narrowing)));
  camera->SetParallelScale(camera->GetParallelScale() * scale[1]);
  if (camera->GetUseExplicitAspectRatio())
  {
    camera->SetExplicitAspectRatio(camera->GetExplicitAspectRatio() * scale[0] / scale[1]);
  }
}

// A renderer of the window, and what it was before.
struct TiledRenderer
{
  vtkSmartPointer<vtkRenderer> Renderer;
  Area Whole;
  Area Part;
  double Viewport[4];
  bool Draw;
  vtkSmartPointer<vtkCamera> Camera; // its own while it draws with another one
  unsigned long Tags[2];

  void UseNarrowCamera()
  {
    this->Camera = this->Renderer->GetActiveCamera();
    const auto narrow = vtkSmartPointer<vtkCamera>::Take(this->Camera->NewInstance());
    narrow->DeepCopy(this->Camera);
    Narrow(narrow, this->Whole, this->Part);
    this->Renderer->SetActiveCamera(narrow);
  }

  void UseOwnCamera()
  {
    if (this->Camera)
    {
      this->Renderer->SetActiveCamera(this->Camera);
      this->Camera = nullptr;
    }
  }

  void End()
  {
    this->UseOwnCamera();
    for (const unsigned long tag : this->Tags)
    {
      this->Renderer->RemoveObserver(tag);
    }
    TiledSupersampling::StretchAgain(this->Renderer->GetPass());
    this->Renderer->SetViewport(this->Viewport);
    this->Renderer->SetDraw(this->Draw);
  }
};

// What no renderer draws into would keep what the last tile had there.
void Clear(vtkRenderWindow* window)
{
  auto* opengl = vtkOpenGLRenderWindow::SafeDownCast(window);
  if (!opengl)
  {
    return;
  }
  opengl->Start();
  vtkOpenGLState* state = opengl->GetState();
  {
    vtkOpenGLState::ScopedglEnableDisable scissor(state, GL_SCISSOR_TEST);
    vtkOpenGLState::ScopedglClearColor color(state);
    state->vtkglDisable(GL_SCISSOR_TEST);
    state->vtkglColorMask(GL_TRUE, GL_TRUE, GL_TRUE, GL_TRUE);
    state->vtkglClearColor(0.0f, 0.0f, 0.0f, 0.0f);
    state->vtkglClear(GL_COLOR_BUFFER_BIT);
  }
  state->PopFramebufferBindings(); // which Start() has pushed
}
}

//------------------------------------------------------------------------------
struct vtkSpherePackingTiles::State
{
  vtkSmartPointer<vtkRenderWindow> Window;
  int Size[2];      // of the window, before
  int TileScale[2]; // likewise
  double TileViewport[4];
  int Tile[2];
  std::vector<std::unique_ptr<TiledRenderer>> Renderers;

  void Add(vtkRenderer* renderer, const int size[2])
  {
    auto tiled = std::make_unique<TiledRenderer>();
    tiled->Renderer = renderer;
    renderer->GetViewport(tiled->Viewport);
    tiled->Draw = renderer->GetDraw() != 0;
    tiled->Whole = AreaOf(tiled->Viewport, size);
    tiled->Part = tiled->Whole;
    const double scale[2] = { static_cast<double>(this->Window->GetSize()[0]),
      static_cast<double>(this->Window->GetSize()[1]) };
    renderer->SetViewport(tiled->Whole[0].Begin / scale[0], tiled->Whole[1].Begin / scale[1],
      tiled->Whole[0].End / scale[0], tiled->Whole[1].End / scale[1]);
    if (auto* opengl = vtkOpenGLRenderWindow::SafeDownCast(this->Window))
    {
      TiledSupersampling::StopRepeating(renderer->GetPass(), opengl);
    }
    tiled->Tags[0] = renderer->AddObserver(
      vtkCommand::StartEvent, tiled.get(), &TiledRenderer::UseNarrowCamera, LastPriority);
    tiled->Tags[1] =
      renderer->AddObserver(vtkCommand::EndEvent, tiled.get(), &TiledRenderer::UseOwnCamera);
    this->Renderers.push_back(std::move(tiled));
  }
};

//------------------------------------------------------------------------------
vtkSpherePackingTiles::vtkSpherePackingTiles() = default;

//------------------------------------------------------------------------------
vtkSpherePackingTiles::~vtkSpherePackingTiles()
{
  this->End();
}

//------------------------------------------------------------------------------
bool vtkSpherePackingTiles::Begin(
  vtkRenderWindow* window, const int size[2], const int tile[2], int scale)
{
  this->End();
  if (!window || window->GetStereoRender() || std::min(size[0], size[1]) < 1 ||
    std::min(tile[0], tile[1]) < 1 || scale < 1)
  {
    return false;
  }
  vtkRendererCollection* renderers = window->GetRenderers();
  vtkCollectionSimpleIterator next;
  renderers->InitTraversal(next);
  while (vtkRenderer* renderer = renderers->GetNextRenderer(next))
  {
    if (renderer->GetActiveCamera()->GetUseOffAxisProjection())
    {
      return false;
    }
  }
  this->Internals = std::make_unique<State>();
  State& state = *this->Internals;
  state.Window = window;
  std::copy_n(window->GetActualSize(), 2, state.Size);
  window->GetTileScale(state.TileScale);
  window->GetTileViewport(state.TileViewport);
  std::copy_n(tile, 2, state.Tile);
  window->SetSize(tile[0], tile[1]);
  window->SetTileScale(scale);
  renderers->InitTraversal(next);
  while (vtkRenderer* renderer = renderers->GetNextRenderer(next))
  {
    state.Add(renderer, size);
  }
  return true;
}

//------------------------------------------------------------------------------
void vtkSpherePackingTiles::Render(int x, int y)
{
  if (!this->Internals)
  {
    vtkErrorMacro("found no picture that has been begun, expected Begin() before Render()");
    return;
  }
  State& state = *this->Internals;
  const Area tile{ { { x, x + state.Tile[0] }, { y, y + state.Tile[1] } } };
  const double width = state.Window->GetSize()[0];
  const double height = state.Window->GetSize()[1];
  state.Window->SetTileViewport(
    tile[0].Begin / width, tile[1].Begin / height, tile[0].End / width, tile[1].End / height);
  for (const auto& tiled : state.Renderers)
  {
    tiled->Part = Overlap(tiled->Whole, tile);
    const bool seen = tiled->Part[0].Length() > 0 && tiled->Part[1].Length() > 0;
    tiled->Renderer->SetDraw(tiled->Draw && seen);
    if (auto* opengl = vtkOpenGLRenderWindow::SafeDownCast(state.Window))
    {
      TiledSupersampling::StopStretching(tiled->Renderer->GetPass(), opengl);
    }
  }
  Clear(state.Window);
  state.Window->Render();
}

//------------------------------------------------------------------------------
void vtkSpherePackingTiles::End()
{
  if (!this->Internals)
  {
    return;
  }
  State& state = *this->Internals;
  for (const auto& tiled : state.Renderers)
  {
    tiled->End();
  }
  state.Window->SetTileScale(state.TileScale);
  state.Window->SetTileViewport(state.TileViewport);
  state.Window->SetSize(state.Size);
  this->Internals.reset();
}
