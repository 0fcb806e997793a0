// SPDX-License-Identifier: BSD-3-Clause
/// A uniform grid and the spheres that touch each of its cells.
#ifndef GridTable_h
#define GridTable_h

#include "base/ParallelFor.h"
#include "base/SphereArrays.h"
#include "accel/Grid.h"

#include <atomic>
#include <memory>
#include <vector>

namespace spherepacking
{
using CellCounts = std::unique_ptr<std::atomic<std::int32_t>[]>;

/// How many spheres touch each cell, their radii enlarged by `margin`.
CellCounts CountTouches(
  const Grid& grid, const SphereArrays& spheres, double margin, const ParallelFor& parallelFor);

/// At least as many as CountTouches() adds up to, from the boxes around the spheres.
double EstimateTouches(const Grid& grid, const SphereArrays& spheres);

struct GridTable
{
  Grid Cells;
  std::vector<std::int64_t> Starts; ///< of each cell in `Ids`, and the end
  std::vector<std::int32_t> Ids;

  std::size_t Bytes() const
  {
    return this->Starts.size() * sizeof(std::int64_t) + this->Ids.size() * sizeof(std::int32_t);
  }
};

/// Lists every sphere with a radius above 0 also in cells that it misses by a few rounding errors,
/// so that it does not matter which of two neighbours a ray passes through when rounding decides.
GridTable BuildGrid(const Grid& grid, const SphereArrays& spheres, const ParallelFor& parallelFor);
}

#endif
