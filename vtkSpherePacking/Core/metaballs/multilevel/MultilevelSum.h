// SPDX-License-Identifier: BSD-3-Clause
#ifndef MultilevelSum_h
#define MultilevelSum_h

#include "metaballs/field/Blobs.h"
#include "metaballs/multilevel/GridTransfer.h"

#include <cmath>

namespace spherepacking
{
inline namespace SPHEREPACKING_ISA
{
/// Multilevel summation of the field of an inverse kernel over blocks of a grid: long-range terms
/// from the levels of the hierarchy, short-range terms directly from the charges within Cutoff.
template <int Power>
class MultilevelSum
{
public:
  /// Both have to outlive this.
  MultilevelSum(const FieldGrid& grid, const GridHierarchy& hierarchy)
    : Grid(grid)
    , Hierarchy(hierarchy)
  {
  }

  /// Sets the grid's field at the points of a block.
  void Run(const FieldBlock& block)
  {
    GridBox box;
    for (int axis = 0; axis < 3; ++axis)
    {
      box.First[axis] = static_cast<int>(block.First[axis]);
      box.Count[axis] = block.Count[axis];
    }
    SumLevels(this->Hierarchy, 0, box, this->Scratch);
    this->AddShortRange();
    ForEachRow(box,
      [&](int y, int z)
      {
        std::copy_n(this->Scratch.Sums.Rows.At(box.First[0], y, z), box.Count[0],
          this->Grid.Field + this->Grid.Index(box.First[0], y, z));
      });
  }

private:
  // Visits the cells whose charges may be within Cutoff of the box.
  void AddShortRange()
  {
    const GridBox& cells = this->Hierarchy.Cells;
    int first[3];
    int last[3];
    for (int axis = 0; axis < 3; ++axis)
    {
      const GridBox& box = this->Scratch.Sums.Rows.Box;
      const int reach =
        static_cast<int>(this->Hierarchy.Cutoff / this->Hierarchy.Spacing[axis]) + 1;
      const int window = this->Hierarchy.Window[axis];
      // Charges are half a window above the first point that they are anterpolated to.
      const int lowest = cells.First[axis] + window / 2;
      const int low = box.First[axis] - reach - 1 - lowest;
      const int high = box.First[axis] + box.Count[axis] + reach - lowest;
      first[axis] = std::max(low, 0) / window;
      last[axis] = std::min(high / window, cells.Count[axis] - 1);
      if (high < 0 || first[axis] > last[axis])
      {
        return;
      }
    }
    for (int y = first[1]; y <= last[1]; ++y)
    {
      for (int x = first[0]; x <= last[0]; ++x)
      {
        // z last: neighbouring cells along it share most points, which stay in the cache.
        for (int z = first[2]; z <= last[2]; ++z)
        {
          const std::int32_t* starts = this->Hierarchy.CellAt(x, y, z);
          AddInBatches(this->Hierarchy.Charges.data() + starts[0], starts[1] - starts[0],
            this->Scratch.Sums.Rows.Box, this->Scratch.Sums.Rows, this->Scratch.AlongZ,
            [this](const Charge& charge, const GridRows& to) { this->AddCharge(charge, to); });
        }
      }
    }
  }

  // The points of the box within Cutoff of a charge along an axis, and how far they are from it.
  struct AxisDistance
  {
    int First;
    int Last;
    float Nearest; // the point nearest to the charge
    float Offset;  // of the charge from that point, in space: accurate as a float even if tiny
    float Spacing;

    float At(int point) const
    {
      return (static_cast<float>(point) - this->Nearest) * this->Spacing - this->Offset;
    }

    Float8 At8(int point) const
    {
      const Float8 lanes{ 0.0f, 1.0f, 2.0f, 3.0f, 4.0f, 5.0f, 6.0f, 7.0f };
      return (lanes + (static_cast<float>(point) - this->Nearest)) * this->Spacing - this->Offset;
    }
  };

  AxisDistance DistanceAlong(int axis, double x) const
  {
    const GridBox& box = this->Scratch.Sums.Rows.Box;
    const double spacing = this->Hierarchy.Spacing[axis];
    const double at = (x - this->Hierarchy.Origin[axis]) / spacing - box.First[axis];
    const double reach = this->Hierarchy.Cutoff / spacing;
    const double nearest = std::nearbyint(at);
    AxisDistance distance;
    distance.First = std::max(static_cast<int>(std::ceil(at - reach)), 0);
    distance.Last = std::min(static_cast<int>(std::floor(at + reach)), box.Count[axis] - 1);
    distance.Nearest = static_cast<float>(nearest);
    distance.Offset = static_cast<float>((at - nearest) * spacing);
    distance.Spacing = static_cast<float>(spacing);
    return distance;
  }

  void AddCharge(const Charge& charge, const GridRows& rows) const
  {
    const AxisDistance x = this->DistanceAlong(0, charge.Position[0]);
    const AxisDistance y = this->DistanceAlong(1, charge.Position[1]);
    const AxisDistance z = this->DistanceAlong(2, charge.Position[2]);
    const ShortRange shortRange(this->Hierarchy, charge);
    for (int k = z.First; k <= z.Last; ++k)
    {
      const float dz = z.At(k);
      float* row = rows.At(rows.Box.First[0], rows.Box.First[1] + y.First, rows.Box.First[2] + k);
      for (int j = y.First; j <= y.Last; ++j, row += rows.Stride)
      {
        const float dy = y.At(j);
        const float squareYZ = dy * dy + dz * dz;
        for (int i = x.First; squareYZ < shortRange.MaxSquare && i <= x.Last; i += 8)
        {
          const Float8 dx = x.At8(i);
          Store(Load<Float8>(row + i) + shortRange(dx * dx + squareYZ), row + i);
        }
      }
    }
  }

  // The field of a charge minus its long-range terms as a function of the squared distance, 0
  // beyond Cutoff. All that it needs are members: through a reference they would be loaded again
  // after every store of a sum.
  class ShortRange
  {
  public:
    ShortRange(const GridHierarchy& hierarchy, const Charge& charge)
      : MaxSquare(static_cast<float>(hierarchy.Cutoff * hierarchy.Cutoff))
      , Inverse(1.0f / this->MaxSquare)
      , Strength(charge.Strength)
      , Shape(static_cast<float>(InverseBlob<Power>::Shape(charge.Radius)))
    {
      std::copy_n(hierarchy.LongRange, GridHierarchy::LongRangeTerms, this->LongRange);
    }

    Float8 operator()(const Float8& square) const
    {
      static_assert(GridHierarchy::LongRangeTerms == 8, "as they are added here");
      const Float8 t = square * this->Inverse;
      // Estrin's scheme, in which fewer operations wait for each other than in Horner's rule.
      const float* c = this->LongRange;
      const Float8 t2 = t * t;
      const Float8 low = (c[0] + c[1] * t) + (c[2] + c[3] * t) * t2;
      const Float8 high = (c[4] + c[5] * t) + (c[6] + c[7] * t) * t2;
      const Float8 longRange = low + high * (t2 * t2);
      const Float8 all = InverseBlob<Power>::Value(square, Float8{} + 1.0f, Float8{} + this->Shape);
      const Float8 value = (all - longRange) * this->Strength;
      return square < this->MaxSquare ? value : Float8{};
    }

    const float MaxSquare;

  private:
    const float Inverse;
    const float Strength;
    const float Shape;
    float LongRange[GridHierarchy::LongRangeTerms];
  };

  const FieldGrid& Grid;
  const GridHierarchy& Hierarchy;
  GridScratch Scratch;
};
}
}

#endif
