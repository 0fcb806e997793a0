// SPDX-License-Identifier: BSD-3-Clause
#ifndef GridPatch_h
#define GridPatch_h

#include "base/LocalVector.h"
#include "metaballs/multilevel/GridHierarchy.h"

#include <algorithm>

namespace spherepacking
{
inline namespace SPHEREPACKING_ISA
{
/// Scratch memory for the values of a box, which can be added to in vectors from any point on.
class GridPatch
{
public:
  /// Takes another box; the values are undefined.
  const GridRows& Reset(const GridBox& box)
  {
    this->Rows = GridRows(box, 8);
    this->Values.resize(std::max(this->Values.size(), static_cast<std::size_t>(this->Rows.Size())));
    this->Rows.Values = this->Values.data();
    return this->Rows;
  }

  GridRows Rows;

private:
  LocalVector<float> Values;
};

/// Calls visit(y, z) for the rows of a box.
template <typename Visit>
inline void ForEachRow(const GridBox& box, Visit visit)
{
  for (int z = box.First[2]; z < box.First[2] + box.Count[2]; ++z)
  {
    for (int y = box.First[1]; y < box.First[1] + box.Count[1]; ++y)
    {
      visit(y, z);
    }
  }
}

/// Calls add(charge, rows) for all charges of a cell, which adds to the values of `rows` in single
/// precision.
///
/// A sum of n floats one after the other is wrong by up to n 2^-24. More than 512 charges are
/// therefore summed in batches, of 512 or of sqrt(n) charges, whichever is more, and the sums of
/// the batches added: the relative error is at most 2^-24 times 1024 or 2 sqrt(n), whichever is
/// more. `box` has all points that the charges add to, `patch` is for the batches.
template <typename Add>
inline void AddInBatches(const Charge* charges, std::int32_t count, const GridBox& box,
  const GridRows& to, GridPatch& patch, Add add)
{
  constexpr std::int32_t few = 512;
  if (count <= few)
  {
    for (std::int32_t i = 0; i < count; ++i)
    {
      add(charges[i], to);
    }
    return;
  }
  const std::int32_t size = std::max(few, static_cast<std::int32_t>(std::sqrt(count)));
  const GridRows& batch = patch.Reset(box);
  for (std::int32_t first = 0; first < count; first += size)
  {
    std::fill_n(batch.Values, batch.Size(), 0.0f);
    for (std::int32_t i = first; i < std::min(count, first + size); ++i)
    {
      add(charges[i], batch);
    }
    ForEachRow(box,
      [&](int y, int z)
      {
        const float* from = batch.At(box.First[0], y, z);
        float* row = to.At(box.First[0], y, z);
        for (int x = 0; x < box.Count[0]; ++x)
        {
          row[x] += from[x];
        }
      });
  }
}
}
}

#endif
