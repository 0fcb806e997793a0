// SPDX-License-Identifier: BSD-3-Clause
/// The grids of multilevel summation with their charges and fields, see GaussianSum.h.
///
/// The spacing doubles from level to level. The points of the finest, level 0, include those where
/// the field is wanted.
#ifndef GridHierarchy_h
#define GridHierarchy_h

#include "base/HugeArray.h"
#include "base/ParallelFor.h"
#include "metaballs/field/Charge.h"
#include "metaballs/field/FieldGrid.h"

#include <cmath>
#include <memory>
#include <vector>

namespace spherepacking
{
/// A box of points of a level. Points are numbered from the origin of the field's grid, at which
/// every level has its point 0; numbers may be negative.
struct GridBox
{
  int First[3] = {};
  int Count[3] = {};

  SPHEREPACKING_INLINE std::int64_t Size() const
  {
    return static_cast<std::int64_t>(this->Count[0]) * this->Count[1] * this->Count[2];
  }
};

/// Values at the points of a box, x fastest. The stride is a multiple of 8 values, a vector, but
/// not of 32, so that neighbouring rows do not fall into the same cache sets.
struct GridRows
{
  GridBox Box;
  std::ptrdiff_t Stride = 0; ///< from row to row along y
  float* Values = nullptr;

  GridRows() = default;
  /// Rows have room for `padding` values behind the last.
  SPHEREPACKING_INLINE explicit GridRows(const GridBox& box, int padding)
    : Box(box)
    , Stride((box.Count[0] + padding + 7) / 8 * 8)
  {
    this->Stride += this->Stride % 32 == 0 ? 8 : 0;
  }

  SPHEREPACKING_INLINE std::ptrdiff_t Size() const
  {
    return this->Stride * this->Box.Count[1] * this->Box.Count[2];
  }

  /// The number of points along x, rounded up to whole vectors.
  SPHEREPACKING_INLINE int Width() const { return (this->Box.Count[0] + 7) / 8 * 8; }

  /// From one value to the next along y or z.
  SPHEREPACKING_INLINE std::ptrdiff_t StrideAlong(int axis) const
  {
    return axis == 1 ? this->Stride : this->Stride * this->Box.Count[1];
  }

  SPHEREPACKING_INLINE float* At(int x, int y, int z) const
  {
    return this->Values + (x - this->Box.First[0]) +
      this->Stride *
      (y - this->Box.First[1] +
        static_cast<std::ptrdiff_t>(this->Box.Count[1]) * (z - this->Box.First[2]));
  }
};

/// Rows that own their values.
struct GridArray
{
  GridRows Rows;

  void Allocate()
  {
    this->Values = HugeArray<float>(static_cast<std::size_t>(this->Rows.Size()));
    this->Rows.Values = this->Values.data();
  }

private:
  HugeArray<float> Values;
};

/// Weights of the points from -Radius to Radius along an axis.
struct AxisStencil
{
  int Radius = 0;
  std::vector<float> Weights;
};

/// A separable stencil: the weight of a point is the product of those along the axes.
struct Stencil
{
  AxisStencil Along[3];
};

/// A level of the hierarchy, and the stencils from and to the next finer one.
struct GridLevel
{
  GridArray Charges;
  GridArray Field;            ///< empty for level 0, whose field is summed block by block
  std::vector<Stencil> Terms; ///< from charges to field, one per term of the Gaussian sum
  Stencil Restriction;        ///< from the charges of the finer level to these
  Stencil Prolongation[2];    ///< from this field to the even and the odd points of the finer one
};

struct GridHierarchy
{
  static constexpr int LongRangeTerms = 8;

  double Origin[3];
  double Spacing[3];               ///< of level 0
  double ChargeVariance = 0.0;     ///< of anterpolation
  double Cutoff = 0.0;             ///< of the short-range terms
  float LongRange[LongRangeTerms]; ///< within it the other terms: a polynomial of (d / Cutoff)^2
  int Window[3];                   ///< points along each axis that a charge is anterpolated to

  /// Cells of Window[0] x Window[1] x Window[2] points. A charge is in the cell in which the points
  /// that it is anterpolated to begin; First is the first of these points of all charges, Count the
  /// number of cells.
  GridBox Cells;
  std::vector<std::int32_t> CellStarts;
  std::vector<Charge> Charges; ///< cell by cell

  std::vector<GridLevel> Levels; ///< from fine to coarse

  /// The first point along an axis that a charge at x is anterpolated to. Increases with x.
  SPHEREPACKING_INLINE int FirstPoint(int axis, double x) const
  {
    return static_cast<int>(
      std::ceil((x - this->Origin[axis]) / this->Spacing[axis] - 0.5 * this->Window[axis]));
  }

  /// The position of a cell's first charge; the next element is that behind its last.
  SPHEREPACKING_INLINE const std::int32_t* CellAt(int x, int y, int z) const
  {
    const GridBox& cells = this->Cells;
    return this->CellStarts.data() + x +
      cells.Count[0] * (y + static_cast<std::ptrdiff_t>(cells.Count[1]) * z);
  }
};

/// Whether multilevel summation can make the field, is faster than the fast multipole method and
/// takes little memory beside the charges.
bool SuitsMultilevel(const std::vector<Charge>& charges, const FieldGrid& grid, int power);

/// Charges and fields of all levels but the field of level 0, which MultilevelSum makes of them.
std::unique_ptr<GridHierarchy> BuildGridHierarchy(
  std::vector<Charge>&& charges, const FieldGrid& grid, int power, const ParallelFor& parallelFor);
}

#endif
