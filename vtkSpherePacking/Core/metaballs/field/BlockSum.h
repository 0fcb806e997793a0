// SPDX-License-Identifier: BSD-3-Clause
#ifndef BlockSum_h
#define BlockSum_h

#include "metaballs/field/Blobs.h"
#include "metaballs/multipole/ChargeTree.h"
#include "metaballs/field/FieldGrid.h"

#include <cmath>

namespace spherepacking
{
/// Size of the blocks whose charges are summed one by one: places along x, and rows of those.
constexpr int MostBlockWidth = 8;
constexpr int MostBlockRows = 64;

SPHEREPACKING_INLINE bool FitsBlockSum(const FieldBlock& block)
{
  return block.Count[0] <= MostBlockWidth && block.Count[1] * block.Count[2] <= MostBlockRows;
}

inline namespace SPHEREPACKING_ISA
{
/// Sums charges one by one at the places of a block.
///
/// Coordinates are taken from the middle of the block in double precision before they become
/// floats, so a distance along an axis is wrong by no more than 2^-24 of the block's size, wherever
/// the block lies. Charges within 1/40 of that size from a place are summed in double precision;
/// the others' distances are right to 40 sqrt(3) 2^-24 = 4.1e-6, and their squares to 8.3e-6.
template <typename Blob>
class BlockSum
{
public:
  /// `estimate` allows values, but no gradients, to be wrong by EstimateError.
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
    this->Exact = size / 40.0;
    for (int x = 0; x < MostBlockWidth; ++x)
    {
      const int inside = std::min(x, block.Count[0] - 1);
      this->PlaceX[x] = static_cast<float>(grid.At(0, block.First[0] + inside) - this->Middle[0]);
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
        std::fill_n(this->Sums[sum][row], MostBlockWidth, 0.0);
      }
    }
    std::fill(this->RowY + this->Rows, this->RowY + MostBlockRows, 0.0f);
    std::fill(this->RowZ + this->Rows, this->RowZ + MostBlockRows, 0.0f);
  }

  /// Charges that may lie anywhere.
  void Add(const Charge* charges, std::int32_t count)
  {
    for (std::int32_t i = 0; i < count; ++i)
    {
      if (this->IsNear(charges[i]))
      {
        this->AddExactly(charges[i]);
      }
      else
      {
        this->Keep(charges[i]);
      }
    }
  }

  /// Charges in a ball.
  void Add(const Charge* charges, std::int32_t count, const double (&center)[3], double radius)
  {
    for (int axis = 0; axis < 3; ++axis)
    {
      if (center[axis] + radius < this->Low[axis] - this->Exact ||
        center[axis] - radius > this->High[axis] + this->Exact)
      {
        for (std::int32_t i = 0; i < count; ++i)
        {
          this->Keep(charges[i]);
        }
        return;
      }
    }
    this->Add(charges, count);
  }

  /// Adds the sums to the grid's arrays.
  void End()
  {
    this->Flush();
    const FieldGrid& grid = *this->Grid;
    for (int row = 0; row < this->Rows; ++row)
    {
      const std::int64_t first =
        grid.Place(this->Block.First[0], this->Block.First[1] + row % this->Block.Count[1],
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
  static constexpr int MostCharges = 64; // 64 roundings of a sum are 4e-6 at most
  static constexpr int Width = 8;        // rows that are summed at once

  void Keep(const Charge& charge)
  {
    this->X[this->Count] = static_cast<float>(charge.X[0] - this->Middle[0]);
    this->Y[this->Count] = static_cast<float>(charge.X[1] - this->Middle[1]);
    this->Z[this->Count] = static_cast<float>(charge.X[2] - this->Middle[2]);
    this->Strength[this->Count] = charge.Strength;
    this->Shape[this->Count] = static_cast<float>(Blob::Shape(charge.Radius));
    if (++this->Count == MostCharges)
    {
      this->Flush();
    }
  }

  void Flush()
  {
    for (int row = 0; row < this->Rows; row += Width)
    {
      if (this->Gradient)
      {
        for (int i = row; i < std::min(row + Width, this->Rows); ++i)
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
    // Squares of the distances along y and z, of all charges first: a number is loaded from memory
    // into all lanes faster than it is shuffled there.
    const Float8 y = Load<Float8>(this->RowY + row);
    const Float8 z = Load<Float8>(this->RowZ + row);
    float aside[MostCharges][Width];
    for (int from = 0; from < this->Count; ++from)
    {
      const Float8 dy = y - this->Y[from];
      const Float8 dz = z - this->Z[from];
      Store(dy * dy + dz * dz, aside[from]);
    }
    const Float8 x = Load<Float8>(this->PlaceX);
    Float8 sums[Width] = {};
    for (int from = 0; from < this->Count; ++from)
    {
      const Float8 strength = Float8{} + this->Strength[from];
      const Float8 shape = Float8{} + this->Shape[from];
      const Float8 dx = x - this->X[from];
      const Float8 along = dx * dx;
#pragma GCC unroll 8
      for (int i = 0; i < Width; ++i)
      {
        sums[i] += ValueOf<Estimated>(along + aside[from][i], strength, shape);
      }
    }
    for (int i = 0; i < Width; ++i)
    {
      for (int lane = 0; lane < MostBlockWidth; ++lane)
      {
        this->Sums[0][row + i][lane] += sums[i][lane];
      }
    }
  }

  void SumGradients(int row)
  {
    const Float8 x = Load<Float8>(this->PlaceX);
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
      for (int lane = 0; lane < MostBlockWidth; ++lane)
      {
        this->Sums[sum][row][lane] += sums[sum][lane];
      }
    }
  }

  // Whether a charge is so near to one of the places that single precision would not do.
  bool IsNear(const Charge& charge) const
  {
    for (int axis = 0; axis < 3; ++axis)
    {
      const double spacing = this->Grid->Spacing[axis];
      const double at = (charge.X[axis] - this->Low[axis]) / spacing;
      const double nearest =
        std::min(std::max(std::nearbyint(at), 0.0), this->Block.Count[axis] - 1.0);
      if (!(std::abs(at - nearest) * spacing < this->Exact))
      {
        return false;
      }
    }
    return true;
  }

  void AddExactly(const Charge& charge)
  {
    const double strength = charge.Strength;
    const double shape = Blob::Shape(charge.Radius);
    for (int row = 0; row < this->Rows; ++row)
    {
      const double dy =
        this->Grid->At(1, this->Block.First[1] + row % this->Block.Count[1]) - charge.X[1];
      const double dz =
        this->Grid->At(2, this->Block.First[2] + row / this->Block.Count[1]) - charge.X[2];
      for (int x = 0; x < this->Block.Count[0]; ++x)
      {
        const double dx = this->Grid->At(0, this->Block.First[0] + x) - charge.X[0];
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
  double Exact = 0.0; // how near a charge may be to a place that is summed in single precision
  int Rows = 0;
  int Count = 0;
  float PlaceX[MostBlockWidth];
  float RowY[MostBlockRows];
  float RowZ[MostBlockRows];
  float X[MostCharges];
  float Y[MostCharges];
  float Z[MostCharges];
  float Strength[MostCharges];
  float Shape[MostCharges];
  // Of values and gradients; a sum of many in single precision would lose digits.
  double Sums[4][MostBlockRows][MostBlockWidth];
};
}
}

#endif
