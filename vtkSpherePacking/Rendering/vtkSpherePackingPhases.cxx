// SPDX-License-Identifier: BSD-3-Clause
#include "vtkSpherePackingPhases.h"

#include <algorithm>
#include <cmath>

VTK_ABI_NAMESPACE_BEGIN
namespace
{
constexpr vtkIdType FewSpheres = 20000;
constexpr double CellSize = 64.0; // pixels
// The shares of the spheres of a cell that are drawn before the next look at what hides what.
constexpr double Ends[] = { 0.2, 0.5, 1.0 };

struct PlacedBlock
{
  int Cell;
  double Depth;
  const vtkSpherePackingBlock* Block;
};

// Where the middle of a block is seen, or false when the block lies outside the depth range.
bool Place(const vtkSpherePackingBlock& block, const vtkSpherePackingVertices& vertices,
  const vtkSpherePackingView& view, PlacedBlock& placed)
{
  std::array<double, 3> middle;
  double half2 = 0.0;
  for (int axis = 0; axis < 3; ++axis)
  {
    const double low = block.Bounds[2 * axis];
    const double high = block.Bounds[2 * axis + 1];
    middle[axis] = 0.5 * (low + high) - vertices.GetOrigin()[axis];
    half2 += 0.25 * (high - low) * (high - low);
  }
  const double reach = std::sqrt(half2) * view.RadiusScale;
  const std::array<double, 3> c = view.ToView(middle);
  const double depth = -c[2];
  if (depth + reach < view.Near || depth - reach > view.Far)
  {
    return false;
  }
  const double scale = view.Parallel ? 1.0 : 1.0 / std::max(depth, view.Near);
  int cell[2];
  for (int axis = 0; axis < 2; ++axis)
  {
    const double pixel = view.PixelMap[axis] * c[axis] * scale + view.PixelMap[2 + axis];
    cell[axis] = static_cast<int>(std::clamp(pixel, 0.0, view.Viewport[2 + axis]) / CellSize);
  }
  placed = { cell[1] * (1 + static_cast<int>(view.Viewport[2] / CellSize)) + cell[0], depth,
    &block };
  return true;
}
}

//------------------------------------------------------------------------------
void vtkSpherePackingRuns::Add(vtkIdType begin, vtkIdType end)
{
  this->Firsts.push_back(static_cast<int>(begin));
  this->Counts.push_back(static_cast<int>(end - begin));
}

//------------------------------------------------------------------------------
std::vector<vtkSpherePackingRuns> vtkSpherePackingMakeOnePhase(
  const vtkSpherePackingVertices& vertices)
{
  std::vector<vtkSpherePackingRuns> phases(1);
  phases[0].Add(0, static_cast<vtkIdType>(vertices.GetPointIds().size()));
  return phases;
}

//------------------------------------------------------------------------------
std::vector<vtkSpherePackingRuns> vtkSpherePackingMakePhases(
  const vtkSpherePackingVertices& vertices, const vtkSpherePackingView& view)
{
  if (static_cast<vtkIdType>(vertices.GetPointIds().size()) < FewSpheres)
  {
    return vtkSpherePackingMakeOnePhase(vertices);
  }
  std::vector<PlacedBlock> blocks;
  blocks.reserve(vertices.GetBlocks().size());
  for (const vtkSpherePackingBlock& block : vertices.GetBlocks())
  {
    PlacedBlock placed;
    if (Place(block, vertices, view, placed))
    {
      blocks.push_back(placed);
    }
  }
  std::sort(blocks.begin(), blocks.end(), [](const PlacedBlock& a, const PlacedBlock& b)
    { return a.Cell != b.Cell ? a.Cell < b.Cell : a.Depth < b.Depth; });

  std::vector<vtkSpherePackingRuns> phases(std::size(Ends));
  for (auto begin = blocks.begin(); begin != blocks.end();)
  {
    const auto end = std::find_if(
      begin, blocks.end(), [&](const PlacedBlock& placed) { return placed.Cell != begin->Cell; });
    const double total = static_cast<double>(end - begin);
    int phase = 0;
    for (auto at = begin; at != end; ++at)
    {
      while (static_cast<double>(at - begin) >= Ends[phase] * total)
      {
        ++phase;
      }
      phases[phase].Add(at->Block->Begin, at->Block->End);
    }
    begin = end;
  }
  return phases;
}
VTK_ABI_NAMESPACE_END
