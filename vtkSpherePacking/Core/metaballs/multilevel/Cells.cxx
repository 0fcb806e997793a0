// SPDX-License-Identifier: BSD-3-Clause
#include "metaballs/multilevel/Cells.h"

#include <algorithm>

namespace spherepacking
{
namespace
{
// The cell of each charge.
std::vector<std::int32_t> OwnersOf(const FieldMesh& mesh, const ParallelFor& parallelFor)
{
  const NodeBox& cells = mesh.Cells;
  const auto count = static_cast<std::int64_t>(mesh.Charges.size());
  std::vector<std::int32_t> owners(mesh.Charges.size());
  constexpr std::int64_t part = 16384;
  parallelFor((count + part - 1) / part,
    [&](std::int64_t number)
    {
      for (std::int64_t i = number * part; i < std::min(count, (number + 1) * part); ++i)
      {
        int at[3];
        for (int axis = 0; axis < 3; ++axis)
        {
          const int node = mesh.LowestNode(axis, mesh.Charges[i].X[axis]);
          at[axis] = (node - cells.First[axis]) / mesh.Window[axis];
        }
        owners[i] = at[0] + cells.Count[0] * (at[1] + cells.Count[1] * at[2]);
      }
    });
  return owners;
}
}

//------------------------------------------------------------------------------
ChargeBox BoxOf(const std::vector<Charge>& charges)
{
  ChargeBox box;
  std::copy_n(charges.front().X, 3, box.Low);
  std::copy_n(charges.front().X, 3, box.High);
  for (const Charge& charge : charges)
  {
    for (int axis = 0; axis < 3; ++axis)
    {
      box.Low[axis] = std::min(box.Low[axis], charge.X[axis]);
      box.High[axis] = std::max(box.High[axis], charge.X[axis]);
    }
  }
  return box;
}

//------------------------------------------------------------------------------
void SortIntoCells(std::vector<Charge>&& charges, FieldMesh& mesh, const ParallelFor& parallelFor)
{
  const NodeBox& nodes = mesh.Levels[0].Charges.Rows.Box;
  for (int axis = 0; axis < 3; ++axis)
  {
    mesh.Cells.First[axis] = nodes.First[axis];
    // Charges begin a window before the nodes end.
    mesh.Cells.Count[axis] = (nodes.Count[axis] - mesh.Window[axis]) / mesh.Window[axis] + 1;
  }
  mesh.Charges = std::move(charges);
  std::vector<std::int32_t> owners = OwnersOf(mesh, parallelFor);
  std::vector<std::int32_t>& starts = mesh.CellStarts;
  starts.assign(static_cast<std::size_t>(mesh.Cells.Nodes()) + 1, 0);
  for (const std::int32_t owner : owners)
  {
    ++starts[owner + 1];
  }
  for (std::size_t cell = 1; cell < starts.size(); ++cell)
  {
    starts[cell] += starts[cell - 1];
  }
  // Where each goes, and then, one circle of exchanges after the other, there.
  std::vector<std::int32_t> next(starts.begin(), starts.end() - 1);
  for (std::int32_t& owner : owners)
  {
    owner = next[owner]++;
  }
  for (std::size_t i = 0; i < owners.size(); ++i)
  {
    while (owners[i] != static_cast<std::int32_t>(i))
    {
      const std::int32_t to = owners[i];
      std::swap(mesh.Charges[i], mesh.Charges[to]);
      std::swap(owners[i], owners[to]);
    }
  }
}
}
