// SPDX-License-Identifier: BSD-3-Clause
/// Sums with Gaussians along the axes of a mesh, one axis after the other: z, y and x.
#ifndef GridTransfer_h
#define GridTransfer_h

#include "metaballs/multilevel/GridPatch.h"

#include <algorithm>

namespace spherepacking
{
inline namespace SPHEREPACKING_ISA
{
/// to[i] is, or if `Add` grows by, the sum of taps[t] from[i + t step] over all taps, for i from
/// `begin` on, in steps of eight times `Parts` as long as these end within the width. Returns where
/// they end.
template <bool Add, int Parts>
inline int SumParts(const float* from, std::ptrdiff_t step, const float* taps, int count, float* to,
  int begin, int width)
{
  int i = begin;
  for (; i + 8 * Parts <= width; i += 8 * Parts)
  {
    Float8 sums[Parts];
#pragma GCC unroll 8
    for (int part = 0; part < Parts; ++part)
    {
      sums[part] = Add ? Load<Float8>(to + i + 8 * part) : Float8{};
    }
    const float* at = from + i;
    for (int t = 0; t < count; ++t, at += step)
    {
      const Float8 tap = Float8{} + taps[t];
#pragma GCC unroll 8
      for (int part = 0; part < Parts; ++part)
      {
        sums[part] += tap * Load<Float8>(at + 8 * part);
      }
    }
#pragma GCC unroll 8
    for (int part = 0; part < Parts; ++part)
    {
      Store(sums[part], to + i + 8 * part);
    }
  }
  return i;
}

/// The same for all i below a width that is a multiple of eight.
template <bool Add>
inline void SumTaps(
  const float* from, std::ptrdiff_t step, const float* taps, int count, float* to, int width)
{
  int i = SumParts<Add, 8>(from, step, taps, count, to, 0, width);
  i = SumParts<Add, 4>(from, step, taps, count, to, i, width);
  SumParts<Add, 1>(from, step, taps, count, to, i, width);
}

/// Sets all values to sums along y or z. Node n of the target is at `middle(n)` of the source, and
/// has the taps `taps(n)`; what is outside the source is 0.
template <typename Middle, typename Taps>
inline void SumAlong(int axis, const MeshRows& from, const MeshRows& to, Middle middle, Taps tapsOf)
{
  const int low = from.Box.First[axis];
  const int end = low + from.Box.Count[axis];
  const int x = to.Box.First[0];
  // The rows that are summed along z stay near if y is the outer loop.
  const int outer = axis == 2 ? 1 : 2;
  for (int o = to.Box.First[outer]; o < to.Box.First[outer] + to.Box.Count[outer]; ++o)
  {
    for (int n = to.Box.First[axis]; n < to.Box.First[axis] + to.Box.Count[axis]; ++n)
    {
      const MeshTaps& taps = tapsOf(n);
      const int first = middle(n) - taps.Radius;
      const int skipped = std::max(low - first, 0);
      const int count = std::min(end - first, 2 * taps.Radius + 1) - skipped;
      float* row = axis == 2 ? to.At(x, o, n) : to.At(x, n, o);
      if (count <= 0)
      {
        std::fill_n(row, to.Width(), 0.0f);
        continue;
      }
      const float* source =
        axis == 2 ? from.At(x, o, first + skipped) : from.At(x, first + skipped, o);
      SumTaps<false>(
        source, from.Step(axis), taps.Weights.data() + skipped, count, row, to.Width());
    }
  }
}

/// Room for sums on the way.
struct MeshScratch
{
  MeshPatch Parts[2];
  MeshPatch Sums;
  LocalVector<float> Source;
  LocalVector<float> Row;

  /// Sums along x for `count` nodes, the first of which is at `middle` of the source's row.
  template <bool Add>
  void SumRow(
    const MeshRows& from, int y, int z, int middle, const MeshTaps& taps, int count, float* to)
  {
    const int width = (count + 7) / 8 * 8;
    const int first = middle - taps.Radius;
    this->Source.assign(width + 2 * taps.Radius, 0.0f);
    const int low = std::max(from.Box.First[0], first);
    const int end =
      std::min(from.Box.First[0] + from.Box.Count[0], first + count + 2 * taps.Radius);
    if (low < end)
    {
      std::copy_n(from.At(low, y, z), end - low, this->Source.data() + (low - first));
    }
    SumTaps<Add>(this->Source.data(), 1, taps.Weights.data(), 2 * taps.Radius + 1, to, width);
  }
};

/// A box with another's extent along an axis.
inline NodeBox WithAxis(NodeBox box, int axis, const NodeBox& other)
{
  box.First[axis] = other.First[axis];
  box.Count[axis] = other.Count[axis];
  return box;
}

/// What of a box is within some nodes of another along y.
inline NodeBox NearAlongY(NodeBox box, const NodeBox& other, int nodes)
{
  const int low = std::max(box.First[1], other.First[1] - nodes);
  const int end = std::min(box.First[1] + box.Count[1], other.First[1] + other.Count[1] + nodes);
  box.First[1] = low;
  box.Count[1] = std::max(end - low, 0);
  return box;
}

/// Adds to each value the sum over the nodes about it.
inline void AddSmoothed(
  const MeshRows& from, const MeshLevel::Kernel& kernel, const MeshRows& to, MeshScratch& scratch)
{
  const MeshTaps(&taps)[3] = kernel.Along;
  const auto same = [](int n) { return n; };
  const NodeBox near = NearAlongY(from.Box, to.Box, taps[1].Radius);
  const MeshRows& flat = scratch.Parts[0].Reset(WithAxis(near, 2, to.Box));
  SumAlong(2, from, flat, same, [&](int) -> const MeshTaps& { return taps[2]; });
  const MeshRows& lines = scratch.Parts[1].Reset(WithAxis(flat.Box, 1, to.Box));
  SumAlong(1, flat, lines, same, [&](int) -> const MeshTaps& { return taps[1]; });
  ForEachRow(to.Box,
    [&](int y, int z)
    {
      scratch.SumRow<true>(
        lines, y, z, to.Box.First[0], taps[0], to.Box.Count[0], to.At(to.Box.First[0], y, z));
    });
}

/// Sets the charges in a box of a mesh, as wide as the mesh, from those of the mesh before.
inline void CollectCharges(const MeshRows& fine, MeshLevel& level, const NodeBox& box)
{
  const MeshTaps(&taps)[3] = level.Down.Along;
  MeshScratch scratch;
  const auto twice = [](int n) { return 2 * n; };
  const MeshRows& flat = scratch.Parts[0].Reset(WithAxis(fine.Box, 2, box));
  SumAlong(2, fine, flat, twice, [&](int) -> const MeshTaps& { return taps[2]; });
  const MeshRows& lines = scratch.Parts[1].Reset(WithAxis(flat.Box, 1, box));
  SumAlong(1, flat, lines, twice, [&](int) -> const MeshTaps& { return taps[1]; });
  scratch.Row.resize(2 * box.Count[0] + 8);
  ForEachRow(box,
    [&](int y, int z)
    {
      scratch.SumRow<false>(
        lines, y, z, 2 * box.First[0], taps[0], 2 * box.Count[0], scratch.Row.data());
      float* row = level.Charges.Rows.At(box.First[0], y, z);
      for (int x = 0; x < box.Count[0]; ++x)
      {
        row[x] = scratch.Row[2 * x];
      }
    });
}

/// Adds a mesh's field to values of the mesh before.
inline void AddCoarser(const MeshLevel& level, const MeshRows& to, MeshScratch& scratch)
{
  const MeshLevel::Kernel(&up)[2] = level.Up;
  const MeshRows& from = level.Field.Rows;
  const auto half = [](int n) { return n >> 1; };
  NodeBox coarse = to.Box;
  coarse.First[1] >>= 1;
  coarse.Count[1] = ((to.Box.First[1] + to.Box.Count[1] - 1) >> 1) - coarse.First[1] + 1;
  const NodeBox near = NearAlongY(from.Box, coarse, up[0].Along[1].Radius);
  const MeshRows& flat = scratch.Parts[0].Reset(WithAxis(near, 2, to.Box));
  SumAlong(2, from, flat, half, [&](int n) -> const MeshTaps& { return up[n & 1].Along[2]; });
  const MeshRows& lines = scratch.Parts[1].Reset(WithAxis(flat.Box, 1, to.Box));
  SumAlong(1, flat, lines, half, [&](int n) -> const MeshTaps& { return up[n & 1].Along[1]; });
  const int first = to.Box.First[0] >> 1;
  const int count = ((to.Box.First[0] + to.Box.Count[0] - 1) >> 1) - first + 1;
  scratch.Row.resize(count + 8);
  ForEachRow(to.Box,
    [&](int y, int z)
    {
      float* row = to.At(to.Box.First[0], y, z);
      for (int odd = 0; odd < 2; ++odd)
      {
        scratch.SumRow<false>(lines, y, z, first, up[odd].Along[0], count, scratch.Row.data());
        // The first node with this remainder, and its neighbours on the coarser mesh.
        for (int i = (to.Box.First[0] & 1) == odd ? 0 : 1; i < to.Box.Count[0]; i += 2)
        {
          row[i] += scratch.Row[((to.Box.First[0] + i) >> 1) - first];
        }
      }
    });
}

/// Sets `scratch.Sums` to the field of the terms that meshes from a level on make, in a box of it.
inline void SumMeshes(
  const FieldMesh& mesh, std::size_t level, const NodeBox& box, MeshScratch& scratch)
{
  const MeshLevel& own = mesh.Levels[level];
  const MeshRows& sums = scratch.Sums.Reset(box);
  std::fill_n(sums.Values, sums.Size(), 0.0f);
  for (const MeshLevel::Kernel& kernel : own.Kernels)
  {
    AddSmoothed(own.Charges.Rows, kernel, sums, scratch);
  }
  if (level + 1 < mesh.Levels.size())
  {
    AddCoarser(mesh.Levels[level + 1], sums, scratch);
  }
}

/// Sets the field in a box of a mesh other than the finest.
inline void MakeMeshField(FieldMesh& mesh, std::size_t level, const NodeBox& box)
{
  MeshScratch scratch;
  SumMeshes(mesh, level, box, scratch);
  ForEachRow(box,
    [&](int y, int z)
    {
      std::copy_n(scratch.Sums.Rows.At(box.First[0], y, z), box.Count[0],
        mesh.Levels[level].Field.Rows.At(box.First[0], y, z));
    });
}
}
}

#endif
