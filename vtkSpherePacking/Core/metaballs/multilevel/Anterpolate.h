// SPDX-License-Identifier: BSD-3-Clause
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
/// Largest number of nodes along an axis that a charge is spread to.
constexpr int MostWindow = 16;

/// Spreads charges to the nodes of mesh 0 as Gaussians.
class ChargeSpreader
{
public:
  explicit ChargeSpreader(const FieldMesh& mesh)
    : Mesh(mesh)
  {
  }

  /// Adds to an array that has all of these nodes.
  void Add(const Charge& charge, const MeshRows& to) const
  {
    int first[3];
    float weights[3][MostWindow];
    for (int axis = 0; axis < 3; ++axis)
    {
      first[axis] = this->WeightsAlong(axis, charge.X[axis], weights[axis]);
    }
    for (int z = 0; z < this->Mesh.Window[2]; ++z)
    {
      const float plane = charge.Strength * weights[2][z];
      float* row = to.At(first[0], first[1], first[2] + z);
      for (int y = 0; y < this->Mesh.Window[1]; ++y, row += to.Stride)
      {
        const float factor = plane * weights[1][y];
        for (int x = 0; x < this->Mesh.Window[0]; x += 8)
        {
          Store(Load<Float8>(row + x) + factor * Load<Float8>(weights[0] + x), row + x);
        }
      }
    }
  }

private:
  // Sets the weights of the nodes along an axis and returns the first of them.
  int WeightsAlong(int axis, double x, float* weights) const
  {
    const double step = this->Mesh.Step[axis];
    const double place = (x - this->Mesh.Origin[axis]) / step;
    const int first = this->Mesh.LowestNode(axis, x);
    const auto inside = static_cast<float>(place - first);
    const auto rate = static_cast<float>(-0.5 * step * step / this->Mesh.Spread);
    const auto scale = static_cast<float>(step / std::sqrt(2.0 * M_PI * this->Mesh.Spread));
    const Float8 lanes{ 0.0f, 1.0f, 2.0f, 3.0f, 4.0f, 5.0f, 6.0f, 7.0f };
    for (int i = 0; i < this->Mesh.Window[axis]; i += 8)
    {
      const Float8 away = lanes + (static_cast<float>(i) - inside);
      Store(scale * Exponential(rate * away * away), weights + i);
    }
    return first;
  }

  const FieldMesh& Mesh;
};

/// Spreads the charges of a row of cells along x. Those of the rows next to it in y and z must not
/// be spread meanwhile.
inline void SpreadCells(FieldMesh& mesh, int y, int z)
{
  const ChargeSpreader spreader(mesh);
  MeshPatch patch;
  for (int x = 0; x < mesh.Cells.Count[0]; ++x)
  {
    NodeBox box;
    const int cell[3] = { x, y, z };
    for (int axis = 0; axis < 3; ++axis)
    {
      box.First[axis] = mesh.Cells.First[axis] + cell[axis] * mesh.Window[axis];
      const NodeBox& all = mesh.Levels[0].Charges.Rows.Box;
      const int end = all.First[axis] + all.Count[axis];
      box.Count[axis] = std::min(2 * mesh.Window[axis], end - box.First[axis]);
    }
    const std::int32_t* starts = mesh.CellAt(x, y, z);
    AddInParts(mesh.Charges.data() + starts[0], starts[1] - starts[0], box,
      mesh.Levels[0].Charges.Rows, patch,
      [&](const Charge& charge, const MeshRows& to) { spreader.Add(charge, to); });
  }
}
}
}

#endif
