// SPDX-License-Identifier: BSD-3-Clause
#ifndef FieldGrid_h
#define FieldGrid_h

#include "base/Simd.h"

#include <cstdint>

namespace spherepacking
{
/// The regular grid at whose points a field is evaluated, and the arrays for its values, x fastest.
struct FieldGrid
{
  double Origin[3];
  double Spacing[3]; ///< above 0
  std::int64_t Dimensions[3];
  double Scale = 1.0;          ///< a length here over the same in the packing's unit
  std::int64_t FirstIndex = 0; ///< of the point that element 0 of the arrays belongs to
  float* Field = nullptr;
  float* Gradient = nullptr;      ///< three per point, or null
  long long* Strongest = nullptr; ///< id of the sphere that adds most, or null

  SPHEREPACKING_INLINE double At(int axis, std::int64_t i) const
  {
    return this->Origin[axis] + static_cast<double>(i) * this->Spacing[axis];
  }

  /// The element of the arrays that belongs to a point.
  SPHEREPACKING_INLINE std::int64_t Index(std::int64_t x, std::int64_t y, std::int64_t z) const
  {
    return x + this->Dimensions[0] * (y + this->Dimensions[1] * z) - this->FirstIndex;
  }
};

/// A box of points of the grid.
struct FieldBlock
{
  std::int64_t First[3];
  int Count[3];

  SPHEREPACKING_INLINE int Points() const
  {
    return this->Count[0] * this->Count[1] * this->Count[2];
  }
};
}

#endif
