// SPDX-License-Identifier: BSD-3-Clause
#include "metaballs/multilevel/Cells.h"

#include <algorithm>

namespace spherepacking
{
namespace
{
// The cell of each charge.
std::vector<std::int32_t> CellsOf(const GridHierarchy& hierarchy, const ParallelFor& parallelFor)
{
  const GridBox& cells = hierarchy.Cells;
  const std::vector<Charge>& charges = hierarchy.Charges;
  const auto count = static_cast<std::int64_t>(charges.size());
  std::vector<std::int32_t> cellOf(charges.size());
  constexpr std::int64_t together = 16384;
  parallelFor((count + together - 1) / together,
    [&](std::int64_t number)
    {
      for (std::int64_t i = number * together; i < std::min(count, (number + 1) * together); ++i)
      {
        int at[3];
        for (int axis = 0; axis < 3; ++axis)
        {
          const int point = hierarchy.FirstPoint(axis, charges[i].Position[axis]);
          at[axis] = (point - cells.First[axis]) / hierarchy.Window[axis];
        }
        cellOf[i] = at[0] + cells.Count[0] * (at[1] + cells.Count[1] * at[2]);
      }
    });
  return cellOf;
}
}

//------------------------------------------------------------------------------
Box BoundsOf(const std::vector<Charge>& charges)
{
  Box box;
  std::copy_n(charges.front().Position, 3, box.Low);
  std::copy_n(charges.front().Position, 3, box.High);
  for (const Charge& charge : charges)
  {
    for (int axis = 0; axis < 3; ++axis)
    {
      box.Low[axis] = std::min(box.Low[axis], charge.Position[axis]);
      box.High[axis] = std::max(box.High[axis], charge.Position[axis]);
    }
  }
  return box;
}

//------------------------------------------------------------------------------
void SortIntoCells(
  std::vector<Charge>&& charges, GridHierarchy& hierarchy, const ParallelFor& parallelFor)
{
  const GridBox& points = hierarchy.Levels[0].Charges.Rows.Box;
  for (int axis = 0; axis < 3; ++axis)
  {
    hierarchy.Cells.First[axis] = points.First[axis];
    // The first point of a charge is at least a window before the end.
    hierarchy.Cells.Count[axis] =
      (points.Count[axis] - hierarchy.Window[axis]) / hierarchy.Window[axis] + 1;
  }
  hierarchy.Charges = std::move(charges);
  std::vector<std::int32_t> targets = CellsOf(hierarchy, parallelFor);
  std::vector<std::int32_t>& starts = hierarchy.CellStarts;
  starts.assign(static_cast<std::size_t>(hierarchy.Cells.Size()) + 1, 0);
  for (const std::int32_t cell : targets)
  {
    ++starts[cell + 1];
  }
  for (std::size_t cell = 1; cell < starts.size(); ++cell)
  {
    starts[cell] += starts[cell - 1];
  }
  // The position of each charge in place of its cell.
  std::vector<std::int32_t> next(starts.begin(), starts.end() - 1);
  for (std::int32_t& target : targets)
  {
    target = next[target]++;
  }
  // Moves the charges there, one cycle of the permutation after the other.
  for (std::size_t i = 0; i < targets.size(); ++i)
  {
    while (targets[i] != static_cast<std::int32_t>(i))
    {
      const std::int32_t to = targets[i];
      std::swap(hierarchy.Charges[i], hierarchy.Charges[to]);
      std::swap(targets[i], targets[to]);
    }
  }
}
}
