// SPDX-License-Identifier: BSD-3-Clause
/// Applies separable stencils to values on a grid, an axis after the other: z, y and x.
#ifndef ApplyStencil_h
#define ApplyStencil_h

#include "metaballs/multilevel/GridPatch.h"

#include <algorithm>

namespace spherepacking
{
inline namespace SPHEREPACKING_ISA
{
/// Sets to[i], or adds to it, the sum of weights[n] from[i + n stride] over all n < count, for i
/// from `begin` on, `Vectors` vectors at a time as long as these end within the width. The sums
/// stay in registers. Returns the end.
template <bool Add, int Vectors>
inline int ApplyToVectors(const float* from, std::ptrdiff_t stride, const float* weights, int count,
  float* to, int begin, int width)
{
  int i = begin;
  for (; i + 8 * Vectors <= width; i += 8 * Vectors)
  {
    Float8 sums[Vectors];
#pragma GCC unroll 8
    for (int part = 0; part < Vectors; ++part)
    {
      sums[part] = Add ? Load<Float8>(to + i + 8 * part) : Float8{};
    }
    const float* at = from + i;
    for (int n = 0; n < count; ++n, at += stride)
    {
      const Float8 weight = Float8{} + weights[n];
#pragma GCC unroll 8
      for (int part = 0; part < Vectors; ++part)
      {
        sums[part] += weight * Load<Float8>(at + 8 * part);
      }
    }
#pragma GCC unroll 8
    for (int part = 0; part < Vectors; ++part)
    {
      Store(sums[part], to + i + 8 * part);
    }
  }
  return i;
}

/// The same for all i below a width that is a multiple of eight.
template <bool Add>
inline void ApplyToRow(
  const float* from, std::ptrdiff_t stride, const float* weights, int count, float* to, int width)
{
  int i = ApplyToVectors<Add, 8>(from, stride, weights, count, to, 0, width);
  i = ApplyToVectors<Add, 4>(from, stride, weights, count, to, i, width);
  ApplyToVectors<Add, 1>(from, stride, weights, count, to, i, width);
}

/// Applies stencils along y or z. Point n of the target has the stencil `stencilOf(n)`, centred at
/// the point `center(n)` of the source; outside its box the source is 0.
template <typename Center, typename StencilOf>
inline void ApplyAlong(
  int axis, const GridRows& from, const GridRows& to, Center center, StencilOf stencilOf)
{
  const int low = from.Box.First[axis];
  const int end = low + from.Box.Count[axis];
  const int x = to.Box.First[0];
  // With y as the outer loop the rows that are summed along z stay in the cache.
  const int outer = axis == 2 ? 1 : 2;
  for (int o = to.Box.First[outer]; o < to.Box.First[outer] + to.Box.Count[outer]; ++o)
  {
    for (int n = to.Box.First[axis]; n < to.Box.First[axis] + to.Box.Count[axis]; ++n)
    {
      const AxisStencil& stencil = stencilOf(n);
      const int first = center(n) - stencil.Radius;
      const int skipped = std::max(low - first, 0);
      const int count = std::min(end - first, 2 * stencil.Radius + 1) - skipped;
      float* row = axis == 2 ? to.At(x, o, n) : to.At(x, n, o);
      if (count <= 0)
      {
        std::fill_n(row, to.Width(), 0.0f);
        continue;
      }
      const float* source =
        axis == 2 ? from.At(x, o, first + skipped) : from.At(x, first + skipped, o);
      ApplyToRow<false>(
        source, from.StrideAlong(axis), stencil.Weights.data() + skipped, count, row, to.Width());
    }
  }
}

/// Scratch memory for the steps of a stencil.
struct GridScratch
{
  GridPatch AlongZ; ///< after the first step
  GridPatch AlongY; ///< after the second
  GridPatch Sums;
  LocalVector<float> Source;
  LocalVector<float> Row;

  /// Applies a stencil along x to `count` points, the first of which is at `center` in the source.
  template <bool Add>
  void ApplyAlongX(const GridRows& from, int y, int z, int center, const AxisStencil& stencil,
    int count, float* to)
  {
    const int width = (count + 7) / 8 * 8;
    const int first = center - stencil.Radius;
    this->Source.assign(width + 2 * stencil.Radius, 0.0f);
    const int low = std::max(from.Box.First[0], first);
    const int end =
      std::min(from.Box.First[0] + from.Box.Count[0], first + count + 2 * stencil.Radius);
    if (low < end)
    {
      std::copy_n(from.At(low, y, z), end - low, this->Source.data() + (low - first));
    }
    ApplyToRow<Add>(
      this->Source.data(), 1, stencil.Weights.data(), 2 * stencil.Radius + 1, to, width);
  }
};

/// A box with the extent of another along an axis.
inline GridBox WithAxis(GridBox box, int axis, const GridBox& other)
{
  box.First[axis] = other.First[axis];
  box.Count[axis] = other.Count[axis];
  return box;
}

/// The part of a box that is within `radius` points of another along y.
inline GridBox ClipAlongY(GridBox box, const GridBox& other, int radius)
{
  const int low = std::max(box.First[1], other.First[1] - radius);
  const int end = std::min(box.First[1] + box.Count[1], other.First[1] + other.Count[1] + radius);
  box.First[1] = low;
  box.Count[1] = std::max(end - low, 0);
  return box;
}

/// Adds to each value of `to` the stencil's sum over the points around it.
inline void AddStencil(
  const GridRows& from, const Stencil& stencil, const GridRows& to, GridScratch& scratch)
{
  const AxisStencil(&along)[3] = stencil.Along;
  const auto same = [](int n) { return n; };
  const GridBox near = ClipAlongY(from.Box, to.Box, along[1].Radius);
  const GridRows& alongZ = scratch.AlongZ.Reset(WithAxis(near, 2, to.Box));
  ApplyAlong(2, from, alongZ, same, [&](int) -> const AxisStencil& { return along[2]; });
  const GridRows& alongY = scratch.AlongY.Reset(WithAxis(alongZ.Box, 1, to.Box));
  ApplyAlong(1, alongZ, alongY, same, [&](int) -> const AxisStencil& { return along[1]; });
  ForEachRow(to.Box,
    [&](int y, int z)
    {
      scratch.ApplyAlongX<true>(
        alongY, y, z, to.Box.First[0], along[0], to.Box.Count[0], to.At(to.Box.First[0], y, z));
    });
}
}
}

#endif
