// SPDX-License-Identifier: BSD-3-Clause
/// Direct summation over a small block of the grid: the P2P step (particle to particle) of the fast
/// multipole method.
#ifndef BlockSum_h
#define BlockSum_h

#include "metaballs/field/Blobs.h"
#include "metaballs/field/Charge.h"
#include "metaballs/field/FieldGrid.h"

#include <cmath>

namespace spherepacking
{
/// Largest block that is summed at once: points along x, and rows of those.
constexpr int MaxBlockWidth = 8;
constexpr int MaxBlockRows = 64;

SPHEREPACKING_INLINE bool FitsBlockSum(const FieldBlock& block)
{
  return block.Count[0] <= MaxBlockWidth && block.Count[1] * block.Count[2] <= MaxBlockRows;
}

inline namespace SPHEREPACKING_ISA
{
/// Sums what each charge adds at each point of a block: Begin(), any number of Add(), End().
///
/// Coordinates are taken relative to the middle of the block before they are rounded to floats, so
/// a distance along an axis is wrong by at most 2^-24 of the block's size s, wherever the block
/// lies, and a distance by sqrt(3) times that. Charges within s / 40 of a point are summed in
/// double precision. For all others the relative error of the distance is therefore at most
/// 40 sqrt(3) 2^-24 = 4.1e-6, and that of its square 8.3e-6. The kernels of 64 charges at a time
/// are summed in single precision, whose rounding adds 64 2^-24 = 4e-6 at most; these sums are
/// summed in double precision.
template <typename Blob>
class BlockSum
{
public:
  /// `estimate` allows a relative error of EstimateError for values, not for gradients.
  void Begin(const FieldGrid& grid, const FieldBlock& block, bool estimate)
  {
    this->Grid = &grid;
    this->Estimate = estimate;
    this->Block = block;
    this->Gradient = grid.Gradient != nullptr;
    this->Count = 0;
    double size = 0.0;
    for (int axis = 0; axis < 3; ++axis)
    {
      const std::int64_t first = block.First[axis];
      this->Low[axis] = grid.At(axis, first);
      this->High[axis] = grid.At(axis, first + block.Count[axis] - 1);
      this->Middle[axis] = 0.5 * (this->Low[axis] + this->High[axis]);
      size = std::max(size, this->High[axis] - this->Low[axis]);
    }
    this->NearDistance = size / 40.0;
    for (int x = 0; x < MaxBlockWidth; ++x)
    {
      const int inside = std::min(x, block.Count[0] - 1);
      this->PointX[x] = static_cast<float>(grid.At(0, block.First[0] + inside) - this->Middle[0]);
    }
    this->Rows = block.Count[1] * block.Count[2];
    for (int row = 0; row < this->Rows; ++row)
    {
      const int y = row % block.Count[1];
      const int z = row / block.Count[1];
      this->RowY[row] = static_cast<float>(grid.At(1, block.First[1] + y) - this->Middle[1]);
      this->RowZ[row] = static_cast<float>(grid.At(2, block.First[2] + z) - this->Middle[2]);
      for (int sum = 0; sum < (this->Gradient ? 4 : 1); ++sum)
      {
        std::fill_n(this->Sums[sum][row], MaxBlockWidth, 0.0);
      }
    }
    std::fill(this->RowY + this->Rows, this->RowY + MaxBlockRows, 0.0f);
    std::fill(this->RowZ + this->Rows, this->RowZ + MaxBlockRows, 0.0f);
  }

  /// Charges anywhere.
  void Add(const Charge* charges, std::int32_t count)
  {
    for (std::int32_t i = 0; i < count; ++i)
    {
      if (this->IsNear(charges[i]))
      {
        this->AddInDouble(charges[i]);
      }
      else
      {
        this->AddInSingle(charges[i]);
      }
    }
  }

  /// Charges in a ball. If it is far from the block as a whole, no charge is tested by itself.
  void Add(const Charge* charges, std::int32_t count, const double (&center)[3], double radius)
  {
    for (int axis = 0; axis < 3; ++axis)
    {
      if (center[axis] + radius < this->Low[axis] - this->NearDistance ||
        center[axis] - radius > this->High[axis] + this->NearDistance)
      {
        for (std::int32_t i = 0; i < count; ++i)
        {
          this->AddInSingle(charges[i]);
        }
        return;
      }
    }
    this->Add(charges, count);
  }

  /// Adds the sums to the grid's arrays.
  void End()
  {
    this->SumBatch();
    const FieldGrid& grid = *this->Grid;
    for (int row = 0; row < this->Rows; ++row)
    {
      const std::int64_t first =
        grid.Index(this->Block.First[0], this->Block.First[1] + row % this->Block.Count[1],
          this->Block.First[2] + row / this->Block.Count[1]);
      for (int x = 0; x < this->Block.Count[0]; ++x)
      {
        grid.Field[first + x] += static_cast<float>(this->Sums[0][row][x]);
        for (int axis = 0; this->Gradient && axis < 3; ++axis)
        {
          grid.Gradient[3 * (first + x) + axis] += static_cast<float>(this->Sums[axis + 1][row][x]);
        }
      }
    }
  }

private:
  static constexpr int BatchSize = 64; // charges whose sum is in single precision, see above
  static constexpr int RowsAtOnce = 8;

  // Puts a charge into the batch, which is summed when it is full.
  void AddInSingle(const Charge& charge)
  {
    this->X[this->Count] = static_cast<float>(charge.Position[0] - this->Middle[0]);
    this->Y[this->Count] = static_cast<float>(charge.Position[1] - this->Middle[1]);
    this->Z[this->Count] = static_cast<float>(charge.Position[2] - this->Middle[2]);
    this->Strength[this->Count] = charge.Strength;
    this->Shape[this->Count] = static_cast<float>(Blob::Shape(charge.Radius));
    if (++this->Count == BatchSize)
    {
      this->SumBatch();
    }
  }

  void SumBatch()
  {
    for (int row = 0; row < this->Rows; row += RowsAtOnce)
    {
      if (this->Gradient)
      {
        for (int i = row; i < std::min(row + RowsAtOnce, this->Rows); ++i)
        {
          this->SumGradients(i);
        }
      }
      else if (Blob::HasEstimate && this->Estimate)
      {
        this->SumValues<Blob::HasEstimate>(row);
      }
      else
      {
        this->SumValues<false>(row);
      }
    }
    this->Count = 0;
  }

  template <bool Estimated>
  static Float8 ValueOf(const Float8& square, const Float8& strength, const Float8& shape)
  {
    if constexpr (Estimated)
    {
      return Blob::Estimate(square, strength, shape);
    }
    else
    {
      return Blob::Value(square, strength, shape);
    }
  }

  template <bool Estimated>
  void SumValues(int row)
  {
    // Squared distances along y and z of all charges first: broadcasting a number from memory to
    // all lanes is faster than shuffling it there from a register.
    const Float8 y = Load<Float8>(this->RowY + row);
    const Float8 z = Load<Float8>(this->RowZ + row);
    float squareYZ[BatchSize][RowsAtOnce];
    for (int from = 0; from < this->Count; ++from)
    {
      const Float8 dy = y - this->Y[from];
      const Float8 dz = z - this->Z[from];
      Store(dy * dy + dz * dz, squareYZ[from]);
    }
    const Float8 x = Load<Float8>(this->PointX);
    Float8 sums[RowsAtOnce] = {};
    for (int from = 0; from < this->Count; ++from)
    {
      const Float8 strength = Float8{} + this->Strength[from];
      const Float8 shape = Float8{} + this->Shape[from];
      const Float8 dx = x - this->X[from];
      const Float8 squareX = dx * dx;
#pragma GCC unroll 8
      for (int i = 0; i < RowsAtOnce; ++i)
      {
        sums[i] += ValueOf<Estimated>(squareX + squareYZ[from][i], strength, shape);
      }
    }
    for (int i = 0; i < RowsAtOnce; ++i)
    {
      for (int lane = 0; lane < MaxBlockWidth; ++lane)
      {
        this->Sums[0][row + i][lane] += sums[i][lane];
      }
    }
  }

  void SumGradients(int row)
  {
    const Float8 x = Load<Float8>(this->PointX);
    Float8 sums[4] = {};
    for (int from = 0; from < this->Count; ++from)
    {
      const Float8 strength = Float8{} + this->Strength[from];
      const Float8 shape = Float8{} + this->Shape[from];
      const Float8 dx = x - this->X[from];
      const float dy = this->RowY[row] - this->Y[from];
      const float dz = this->RowZ[row] - this->Z[from];
      const Float8 square = dx * dx + (dy * dy + dz * dz);
      const Float8 slope = Blob::Slope(square, strength, shape);
      sums[0] += Blob::Value(square, strength, shape);
      sums[1] += slope * dx;
      sums[2] += slope * dy;
      sums[3] += slope * dz;
    }
    for (int sum = 0; sum < 4; ++sum)
    {
      for (int lane = 0; lane < MaxBlockWidth; ++lane)
      {
        this->Sums[sum][row][lane] += sums[sum][lane];
      }
    }
  }

  // Whether a charge is too near to a point of the block for single precision.
  bool IsNear(const Charge& charge) const
  {
    for (int axis = 0; axis < 3; ++axis)
    {
      const double spacing = this->Grid->Spacing[axis];
      const double at = (charge.Position[axis] - this->Low[axis]) / spacing;
      const double nearest =
        std::min(std::max(std::nearbyint(at), 0.0), this->Block.Count[axis] - 1.0);
      if (!(std::abs(at - nearest) * spacing < this->NearDistance))
      {
        return false;
      }
    }
    return true;
  }

  void AddInDouble(const Charge& charge)
  {
    const double strength = charge.Strength;
    const double shape = Blob::Shape(charge.Radius);
    for (int row = 0; row < this->Rows; ++row)
    {
      const double dy =
        this->Grid->At(1, this->Block.First[1] + row % this->Block.Count[1]) - charge.Position[1];
      const double dz =
        this->Grid->At(2, this->Block.First[2] + row / this->Block.Count[1]) - charge.Position[2];
      for (int x = 0; x < this->Block.Count[0]; ++x)
      {
        const double dx = this->Grid->At(0, this->Block.First[0] + x) - charge.Position[0];
        const double square = dx * dx + dy * dy + dz * dz;
        this->Sums[0][row][x] += Blob::Value(square, strength, shape);
        if (this->Gradient)
        {
          const double slope = Blob::Slope(square, strength, shape);
          this->Sums[1][row][x] += slope * dx;
          this->Sums[2][row][x] += slope * dy;
          this->Sums[3][row][x] += slope * dz;
        }
      }
    }
  }

  const FieldGrid* Grid = nullptr;
  FieldBlock Block;
  bool Estimate = false;
  bool Gradient = false;
  double Low[3];
  double High[3];
  double Middle[3];
  double NearDistance = 0.0; // along all axes: below it charges are summed in double precision
  int Rows = 0;
  int Count = 0; // of the batch
  // All relative to the middle of the block.
  float PointX[MaxBlockWidth];
  float RowY[MaxBlockRows];
  float RowZ[MaxBlockRows];
  float X[BatchSize]; // of the batch, as what follows
  float Y[BatchSize];
  float Z[BatchSize];
  float Strength[BatchSize];
  float Shape[BatchSize];
  // Of values and gradients.
  double Sums[4][MaxBlockRows][MaxBlockWidth];
};
}
}

#endif
