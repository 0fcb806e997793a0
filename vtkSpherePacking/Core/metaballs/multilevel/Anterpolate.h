// SPDX-License-Identifier: BSD-3-Clause
/// Anterpolation: point charges become charges at grid points.
#ifndef Anterpolate_h
#define Anterpolate_h

#include "metaballs/field/Exponential.h"
#include "metaballs/multilevel/GridPatch.h"

#include <algorithm>
#include <cmath>

namespace spherepacking
{
inline namespace SPHEREPACKING_ISA
{
/// Most points along an axis that a charge is anterpolated to.
constexpr int MaxWindow = 16;

/// Adds charges to points of level 0 as Gaussians.
class Anterpolator
{
public:
  explicit Anterpolator(const GridHierarchy& hierarchy)
    : Hierarchy(hierarchy)
  {
  }

  /// `to` has all points of the charge's window.
  void Add(const Charge& charge, const GridRows& to) const
  {
    const int (&window)[3] = this->Hierarchy.Window;
    int first[3];
    float weights[3][MaxWindow];
    for (int axis = 0; axis < 3; ++axis)
    {
      first[axis] = this->WeightsAlong(axis, charge.Position[axis], weights[axis]);
    }
    for (int z = 0; z < window[2]; ++z)
    {
      const float plane = charge.Strength * weights[2][z];
      float* row = to.At(first[0], first[1], first[2] + z);
      for (int y = 0; y < window[1]; ++y, row += to.Stride)
      {
        const float factor = plane * weights[1][y];
        for (int x = 0; x < window[0]; x += 8)
        {
          Store(Load<Float8>(row + x) + factor * Load<Float8>(weights[0] + x), row + x);
        }
      }
    }
  }

private:
  // Sets the weights of the points along an axis and returns the first of them.
  int WeightsAlong(int axis, double x, float* weights) const
  {
    const double spacing = this->Hierarchy.Spacing[axis];
    const double variance = this->Hierarchy.ChargeVariance;
    const double at = (x - this->Hierarchy.Origin[axis]) / spacing;
    const int first = this->Hierarchy.FirstPoint(axis, x);
    const auto inside = static_cast<float>(at - first);
    const auto rate = static_cast<float>(-0.5 * spacing * spacing / variance);
    const auto scale = static_cast<float>(spacing / std::sqrt(2.0 * M_PI * variance));
    const Float8 lanes{ 0.0f, 1.0f, 2.0f, 3.0f, 4.0f, 5.0f, 6.0f, 7.0f };
    for (int i = 0; i < this->Hierarchy.Window[axis]; i += 8)
    {
      const Float8 distance = lanes + (static_cast<float>(i) - inside);
      Store(scale * Exponential(rate * distance * distance), weights + i);
    }
    return first;
  }

  const GridHierarchy& Hierarchy;
};

/// Anterpolates the charges of a row of cells along x. Those of the neighbouring rows along y and z
/// add to the same points and must not be anterpolated at the same time.
inline void AnterpolateCellsImpl(GridHierarchy& hierarchy, int y, int z)
{
  const Anterpolator anterpolator(hierarchy);
  const GridRows& grid = hierarchy.Levels[0].Charges.Rows;
  GridPatch patch;
  for (int x = 0; x < hierarchy.Cells.Count[0]; ++x)
  {
    GridBox box;
    const int cell[3] = { x, y, z };
    for (int axis = 0; axis < 3; ++axis)
    {
      const int window = hierarchy.Window[axis];
      box.First[axis] = hierarchy.Cells.First[axis] + cell[axis] * window;
      const int end = grid.Box.First[axis] + grid.Box.Count[axis];
      box.Count[axis] = std::min(2 * window, end - box.First[axis]);
    }
    const std::int32_t* starts = hierarchy.CellAt(x, y, z);
    AddInBatches(hierarchy.Charges.data() + starts[0], starts[1] - starts[0], box, grid, patch,
      [&](const Charge& charge, const GridRows& to) { anterpolator.Add(charge, to); });
  }
}
}
}

#endif
