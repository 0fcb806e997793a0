// SPDX-License-Identifier: BSD-3-Clause
#include "bridge/PreparedScene.h"

#include "accel/BuildBvh.h"
#include "bridge/CoordinateRange.h"
#include "bridge/Guard.h"
#include "bridge/MemoryLimit.h"
#include "bridge/RadiusArray.h"
#include "bridge/SmpParallelFor.h"

#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"

#include <algorithm>
#include <cmath>
#include <string>

namespace spherepacking
{
namespace
{
Grid GridOf(vtkPolyData* packing, vtkDataArray* radii, std::int64_t cells)
{
  double bounds[6];
  ComputeBounds(packing, radii, bounds);
  return { { { bounds[0], bounds[2], bounds[4] }, { bounds[1], bounds[3], bounds[5] } }, cells };
}

// Twice as many cells as spheres, or fewer when these are so large that the lists become long.
Grid SuitableGrid(vtkPolyData* packing, vtkDataArray* radii, const SphereArrays& spheres)
{
  const double count = static_cast<double>(spheres.Count);
  double cells = std::max(1.0, std::ceil(std::cbrt(2.0 * count)));
  for (;;)
  {
    const Grid grid = GridOf(packing, radii, static_cast<std::int64_t>(cells));
    if (cells <= 2.0 || EstimateTouches(grid, spheres) <= 64.0 * count)
    {
      return grid;
    }
    cells = std::floor(0.7 * cells);
  }
}

void CheckGrid(const Grid& grid, const SphereArrays& spheres, int cuts)
{
  const double cells = std::pow(static_cast<double>(grid.Cells), 3.0);
  const double room = HalfOfMemory();
  if (16.0 * cells > room || 16.0 * cells + 4.0 * EstimateTouches(grid, spheres) > room)
  {
    throw std::invalid_argument("cuts: found " + std::to_string(cuts) +
      ", which makes more cells than fit in half of the memory with their spheres, expected "
      "fewer");
  }
}

SpheresState StateOf(vtkPolyData* packing, const char* radiusArrayName)
{
  SpheresState state;
  if (packing && packing->GetPoints())
  {
    vtkPoints* points = packing->GetPoints();
    state.Points = points->GetData();
    state.Radii = packing->GetPointData()->GetArray(radiusArrayName);
    state.Time = std::max({ points->GetMTime(), points->GetData()->GetMTime(),
      state.Radii ? state.Radii->GetMTime() : 0 });
  }
  return state;
}

SphereSamples SamplesOf(vtkDataArray* points, vtkDataArray* radii)
{
  SphereSamples samples;
  const vtkIdType spheres = radii->GetNumberOfTuples();
  const vtkIdType count = std::min<vtkIdType>(spheres, SphereSamples::Most);
  for (vtkIdType i = 0; i < count; ++i)
  {
    const vtkIdType at = count < spheres ? i * (spheres - 1) / (count - 1) : i;
    points->GetTuple(at, &samples.Centers[3 * i]);
    samples.Radii[i] = radii->GetComponent(at, 0);
  }
  return samples;
}
}

//------------------------------------------------------------------------------
bool PreparedScene::IsUpToDate(const SpheresState& state, const StructureOptions& options) const
{
  return state.Radii && state == this->Made && options.Kind == this->Kind &&
    options.Cuts == this->Cuts;
}

//------------------------------------------------------------------------------
void PreparedScene::Prepare(vtkPolyData* packing, const StructureOptions& options)
{
  const SpheresState state = StateOf(packing, options.RadiusArrayName);
  if (this->IsUpToDate(state, options))
  {
    return;
  }
  vtkDataArray* radii = RadiiOf(packing, options.RadiusArrayName);
  *this = PreparedScene();
  if (!radii)
  {
    return;
  }
  double bounds[6];
  ComputeBounds(packing, radii, bounds);
  CheckCoordinateRange(bounds);
  const Stopwatch watch;
  this->Spheres.reset(new PackingSpheres(packing, radii));
  this->Build(packing, radii, options);
  this->Seconds = watch.Seconds();
  this->Samples = SamplesOf(state.Points, radii);
  this->Made = state;
  this->Kind = options.Kind;
  this->Cuts = options.Cuts;
}

//------------------------------------------------------------------------------
void PreparedScene::Build(
  vtkPolyData* packing, vtkDataArray* radii, const StructureOptions& options)
{
  const SphereArrays& spheres = this->Spheres->Get();
  CheckCount(spheres.Count);
  if (options.Kind == StructureKind::Bvh)
  {
    this->Hierarchy.reset(new Bvh(BuildBvh(spheres, SmpParallelFor())));
  }
  else if (options.Kind == StructureKind::Grid)
  {
    if (options.Cuts < -1)
    {
      Refuse("cuts", options.Cuts, "0 or more, or -1");
    }
    const Grid grid = options.Cuts < 0
      ? SuitableGrid(packing, radii, spheres)
      : GridOf(packing, radii, static_cast<std::int64_t>(options.Cuts) + 1);
    CheckGrid(grid, spheres, options.Cuts);
    this->Table.reset(new GridTable(BuildGrid(grid, spheres, SmpParallelFor())));
  }
  if (!this->Hierarchy || !this->Hierarchy->Exact)
  {
    this->Spheres->Own(SmpParallelFor());
  }
}

//------------------------------------------------------------------------------
void PreparedScene::NoticeChanges()
{
  vtkDataArray* points = this->Made.Points;
  vtkDataArray* radii = this->Made.Radii;
  if (!radii || points->GetNumberOfTuples() != radii->GetNumberOfTuples())
  {
    return;
  }
  const SphereSamples now = SamplesOf(points, radii);
  if (now.Centers != this->Samples.Centers)
  {
    points->Modified();
  }
  if (now.Radii != this->Samples.Radii)
  {
    radii->Modified();
  }
}

//------------------------------------------------------------------------------
void PreparedScene::SetColors(vtkPolyData* packing, const ColorOptions& options)
{
  this->Colors.Update(packing, options);
}

//------------------------------------------------------------------------------
Scene PreparedScene::Get() const
{
  Scene scene;
  if (this->Spheres)
  {
    scene.Spheres = this->Spheres->Get();
  }
  scene.Hierarchy = this->Hierarchy.get();
  scene.Table = this->Table.get();
  scene.Colors = this->Colors.Data();
  return scene;
}

//------------------------------------------------------------------------------
double PreparedScene::StructureBytes() const
{
  return this->Hierarchy ? static_cast<double>(this->Hierarchy->Bytes())
    : this->Table        ? static_cast<double>(this->Table->Bytes())
                         : 0.0;
}
}
