// SPDX-License-Identifier: BSD-3-Clause
#include "accel/GridTable.h"

namespace spherepacking
{
namespace
{
constexpr std::int64_t Chunk = 1 << 12;

// Calls visit(cell, id) for all touches, in parallel over the spheres.
template <typename Visit>
void ForEachTouch(const Grid& grid, const SphereArrays& spheres, double margin, double least,
  const ParallelFor& parallelFor, const Visit& visit)
{
  parallelFor((spheres.Count + Chunk - 1) / Chunk,
    [&](std::int64_t chunk)
    {
      const std::int64_t end = std::min((chunk + 1) * Chunk, spheres.Count);
      for (std::int64_t i = chunk * Chunk; i < end; ++i)
      {
        Sphere sphere = spheres[i];
        if (sphere.R >= least)
        {
          sphere.R += margin;
          grid.ForEachTouched(sphere, [&](std::int64_t cell) { visit(cell, i); });
        }
      }
    });
}

CellCounts Count(const Grid& grid, const SphereArrays& spheres, double margin, double least,
  const ParallelFor& parallelFor)
{
  CellCounts counts(new std::atomic<std::int32_t>[grid.Count()]());
  ForEachTouch(grid, spheres, margin, least, parallelFor,
    [&](std::int64_t cell, std::int64_t) { counts[cell].fetch_add(1, std::memory_order_relaxed); });
  return counts;
}
}

//------------------------------------------------------------------------------
CellCounts CountTouches(
  const Grid& grid, const SphereArrays& spheres, double margin, const ParallelFor& parallelFor)
{
  return Count(grid, spheres, margin, 0.0, parallelFor);
}

//------------------------------------------------------------------------------
double EstimateTouches(const Grid& grid, const SphereArrays& spheres)
{
  const double cells = static_cast<double>(grid.Cells);
  double perLength[3];
  for (int axis = 0; axis < 3; ++axis)
  {
    const double extent = grid.Bounds.High[axis] - grid.Bounds.Low[axis];
    perLength[axis] = extent > 0.0 ? cells / extent : 0.0;
  }
  double sum = 0.0;
  for (std::int64_t i = 0; i < spheres.Count; ++i)
  {
    double touched = 1.0;
    for (const double scale : perLength)
    {
      // Where all lies in a plane, that belongs to every cell across it.
      touched *= scale > 0.0 ? std::min(cells, 2.0 * spheres[i].R * scale + 2.0) : cells;
    }
    sum += touched;
  }
  return sum;
}

//------------------------------------------------------------------------------
GridTable BuildGrid(const Grid& grid, const SphereArrays& spheres, const ParallelFor& parallelFor)
{
  double extent = 0.0;
  for (int axis = 0; axis < 3; ++axis)
  {
    extent = std::max(extent, grid.Bounds.High[axis] - grid.Bounds.Low[axis]);
  }
  const double margin = 1e-6 * extent / static_cast<double>(grid.Cells);
  constexpr double least = std::numeric_limits<double>::min();
  CellCounts counts = Count(grid, spheres, margin, least, parallelFor);
  GridTable table;
  table.Cells = grid;
  table.Starts.resize(grid.Count() + 1);
  std::int64_t sum = 0;
  for (std::int64_t cell = 0; cell < grid.Count(); ++cell)
  {
    table.Starts[cell] = sum;
    sum += counts[cell].load(std::memory_order_relaxed);
  }
  table.Starts[grid.Count()] = sum;
  table.Ids.resize(sum);
  ForEachTouch(grid, spheres, margin, least, parallelFor,
    [&](std::int64_t cell, std::int64_t id)
    {
      const std::int32_t remaining = counts[cell].fetch_sub(1, std::memory_order_relaxed);
      table.Ids[table.Starts[cell + 1] - remaining] = static_cast<std::int32_t>(id);
    });
  return table;
}
}
