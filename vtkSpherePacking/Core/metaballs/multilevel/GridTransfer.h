// SPDX-License-Identifier: BSD-3-Clause
/// Transfer between the grids of multilevel summation: restriction of charges, prolongation of the
/// field.
#ifndef GridTransfer_h
#define GridTransfer_h

#include "metaballs/multilevel/ApplyStencil.h"

namespace spherepacking
{
inline namespace SPHEREPACKING_ISA
{
/// Restriction: sets charges of a level from those of the finer one, in a box as wide as the level.
inline void RestrictImpl(const GridRows& fine, GridLevel& level, const GridBox& box)
{
  const AxisStencil(&along)[3] = level.Restriction.Along;
  GridScratch scratch;
  const auto twice = [](int n) { return 2 * n; };
  const GridRows& alongZ = scratch.AlongZ.Reset(WithAxis(fine.Box, 2, box));
  ApplyAlong(2, fine, alongZ, twice, [&](int) -> const AxisStencil& { return along[2]; });
  const GridRows& alongY = scratch.AlongY.Reset(WithAxis(alongZ.Box, 1, box));
  ApplyAlong(1, alongZ, alongY, twice, [&](int) -> const AxisStencil& { return along[1]; });
  // Along x at all points, of which every other is used: vectors need them side by side.
  scratch.Row.resize(2 * box.Count[0] + 8);
  ForEachRow(box,
    [&](int y, int z)
    {
      scratch.ApplyAlongX<false>(
        alongY, y, z, 2 * box.First[0], along[0], 2 * box.Count[0], scratch.Row.data());
      float* row = level.Charges.Rows.At(box.First[0], y, z);
      for (int x = 0; x < box.Count[0]; ++x)
      {
        row[x] = scratch.Row[2 * x];
      }
    });
}

/// Prolongation: adds the field of a level to values at points of the finer level.
///
/// Even points of that are points of the coarser grid, odd ones lie between two; along each axis
/// both have a stencil of their own.
inline void Prolongate(const GridLevel& level, const GridRows& to, GridScratch& scratch)
{
  const Stencil(&stencils)[2] = level.Prolongation;
  const GridRows& from = level.Field.Rows;
  const auto half = [](int n) { return n >> 1; };
  GridBox coarse = to.Box;
  coarse.First[1] >>= 1;
  coarse.Count[1] = ((to.Box.First[1] + to.Box.Count[1] - 1) >> 1) - coarse.First[1] + 1;
  const GridBox near = ClipAlongY(from.Box, coarse, stencils[0].Along[1].Radius);
  const GridRows& alongZ = scratch.AlongZ.Reset(WithAxis(near, 2, to.Box));
  ApplyAlong(
    2, from, alongZ, half, [&](int n) -> const AxisStencil& { return stencils[n & 1].Along[2]; });
  const GridRows& alongY = scratch.AlongY.Reset(WithAxis(alongZ.Box, 1, to.Box));
  ApplyAlong(
    1, alongZ, alongY, half, [&](int n) -> const AxisStencil& { return stencils[n & 1].Along[1]; });
  const int first = to.Box.First[0] >> 1;
  const int count = ((to.Box.First[0] + to.Box.Count[0] - 1) >> 1) - first + 1;
  scratch.Row.resize(count + 8);
  ForEachRow(to.Box,
    [&](int y, int z)
    {
      float* row = to.At(to.Box.First[0], y, z);
      for (int odd = 0; odd < 2; ++odd)
      {
        scratch.ApplyAlongX<false>(
          alongY, y, z, first, stencils[odd].Along[0], count, scratch.Row.data());
        for (int i = (to.Box.First[0] & 1) == odd ? 0 : 1; i < to.Box.Count[0]; i += 2)
        {
          row[i] += scratch.Row[((to.Box.First[0] + i) >> 1) - first];
        }
      }
    });
}

/// Sets `scratch.Sums` to the field of the terms of a level and all coarser ones, in a box of it.
inline void SumLevels(
  const GridHierarchy& hierarchy, std::size_t level, const GridBox& box, GridScratch& scratch)
{
  const GridLevel& own = hierarchy.Levels[level];
  const GridRows& sums = scratch.Sums.Reset(box);
  std::fill_n(sums.Values, sums.Size(), 0.0f);
  for (const Stencil& term : own.Terms)
  {
    AddStencil(own.Charges.Rows, term, sums, scratch);
  }
  if (level + 1 < hierarchy.Levels.size())
  {
    Prolongate(hierarchy.Levels[level + 1], sums, scratch);
  }
}

/// Sets the field of a level other than the finest in a box of it.
inline void SetFieldImpl(GridHierarchy& hierarchy, std::size_t level, const GridBox& box)
{
  GridScratch scratch;
  SumLevels(hierarchy, level, box, scratch);
  ForEachRow(box,
    [&](int y, int z)
    {
      std::copy_n(scratch.Sums.Rows.At(box.First[0], y, z), box.Count[0],
        hierarchy.Levels[level].Field.Rows.At(box.First[0], y, z));
    });
}
}
}

#endif
