// SPDX-License-Identifier: BSD-3-Clause
#ifndef GridPatch_h
#define GridPatch_h

#include "metaballs/multilevel/GridHierarchy.h"
#include "base/LocalVector.h"

#include <algorithm>

namespace spherepacking
{
inline namespace SPHEREPACKING_ISA
{
/// An array for sums on the way, which may be added to in eights that begin anywhere in its box.
class MeshPatch
{
public:
  /// Its values mean nothing yet.
  const MeshRows& Reset(const NodeBox& box)
  {
    this->Rows = MeshRows(box, 8);
    this->Values.resize(std::max(this->Values.size(), static_cast<std::size_t>(this->Rows.Size())));
    this->Rows.Values = this->Values.data();
    return this->Rows;
  }

  MeshRows Rows;

private:
  LocalVector<float> Values;
};

/// Calls visit(y, z) for the rows of a box.
template <typename Visit>
inline void ForEachRow(const NodeBox& box, Visit visit)
{
  for (int z = box.First[2]; z < box.First[2] + box.Count[2]; ++z)
  {
    for (int y = box.First[1]; y < box.First[1] + box.Count[1]; ++y)
    {
      visit(y, z);
    }
  }
}

/// Calls add(charge, rows) for charges, which adds to values in single precision. Of a cell's
/// charges in one place that many would lose digits, some are added up by themselves first: n
/// charges are wrong by 2^-24 times 512, or twice the root of n, at most. `box` has all nodes that
/// they change.
template <typename Add>
inline void AddInParts(const Charge* charges, std::int32_t count, const NodeBox& box,
  const MeshRows& to, MeshPatch& patch, Add add)
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
  const std::int32_t most = std::max(few, static_cast<std::int32_t>(std::sqrt(count)));
  const MeshRows& part = patch.Reset(box);
  for (std::int32_t first = 0; first < count; first += most)
  {
    std::fill_n(part.Values, part.Size(), 0.0f);
    for (std::int32_t i = first; i < std::min(count, first + most); ++i)
    {
      add(charges[i], part);
    }
    ForEachRow(box,
      [&](int y, int z)
      {
        const float* from = part.At(box.First[0], y, z);
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
