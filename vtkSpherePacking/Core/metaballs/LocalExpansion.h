// SPDX-License-Identifier: BSD-3-Clause
#ifndef LocalExpansion_h
#define LocalExpansion_h

#include "kernels/Simd.h"
#include "metaballs/Moments.h"

#include <cstddef>

namespace spherepacking
{
/// A polynomial about a place: its derivatives there, in a unit of length.
struct LocalExpansion
{
  double Center[3];
  double Unit = 1.0;
  double Derivatives[MostMonomials] = {}; ///< in the order of a MultiIndex
};

/// A regular grid of places, from the centre of an expansion.
struct LocalGrid
{
  double First[3];
  double Step[3];
  int Count[3]; ///< at most 512 along the first
};

inline namespace SPHEREPACKING_ISA
{
/// Adds the same polynomial about another centre and in another unit.
inline void ShiftLocal(const MultiIndex& index, const LocalExpansion& from, LocalExpansion& to)
{
  double point[3];
  for (int axis = 0; axis < 3; ++axis)
  {
    point[axis] = (to.Center[axis] - from.Center[axis]) / from.Unit;
  }
  double shifts[MostMonomials];
  Monomials(index, point, shifts);
  double shrinks[MostOrder + 1] = { 1.0 };
  for (int n = 1; n <= index.Order; ++n)
  {
    shrinks[n] = shrinks[n - 1] * (to.Unit / from.Unit);
  }
  ForEachMonomial(index,
    [&](int i, int j, int k, int place)
    {
      const int most = index.Order - i - j - k;
      double sum = 0.0;
      for (int a = 0; a <= most; ++a)
      {
        for (int b = 0; a + b <= most; ++b)
        {
          const double* of = from.Derivatives + index.Rows[i + a][j + b] + k;
          const double* by = shifts + index.Rows[a][b];
          for (int c = 0; a + b + c <= most; ++c)
          {
            sum += of[c] * by[c];
          }
        }
      }
      to.Derivatives[place] += sum * shrinks[i + j + k];
    });
}

/// Its derivative along an axis.
inline LocalExpansion DerivativeOf(const MultiIndex& index, const LocalExpansion& local, int axis)
{
  LocalExpansion result;
  std::copy_n(local.Center, 3, result.Center);
  result.Unit = local.Unit;
  ForEachMonomial(index,
    [&](int i, int j, int k, int place)
    {
      if (i + j + k < index.Order)
      {
        result.Derivatives[place] =
          local.Derivatives[index(i + (axis == 0), j + (axis == 1), k + (axis == 2))] / local.Unit;
      }
    });
  return result;
}

/// Calls add(x, y, z, eight values from x on) for all places of the grid, eight at once along x;
/// those beyond the last mean nothing.
template <typename Add>
inline void ForEachLocalValue(
  const MultiIndex& index, const LocalExpansion& local, const LocalGrid& grid, Add add)
{
  const int order = index.Order;
  const auto at = [&](int axis, int i)
  { return (grid.First[axis] + i * grid.Step[axis]) / local.Unit; };
  for (int z = 0; z < grid.Count[2]; ++z)
  {
    double powers[MostOrder + 1] = { 1.0 };
    for (int n = 1; n <= order; ++n)
    {
      powers[n] = powers[n - 1] * at(2, z) / n;
    }
    double plane[MostOrder + 1][MostOrder + 1];
    for (int i = 0; i <= order; ++i)
    {
      for (int j = 0; i + j <= order; ++j)
      {
        const double* row = local.Derivatives + index.Rows[i][j];
        double sum = 0.0;
        for (int k = 0; i + j + k <= order; ++k)
        {
          sum += row[k] * powers[k];
        }
        plane[i][j] = sum;
      }
    }
    for (int y = 0; y < grid.Count[1]; ++y)
    {
      for (int n = 1; n <= order; ++n)
      {
        powers[n] = powers[n - 1] * at(1, y) / n;
      }
      float line[MostOrder + 1];
      double factorial = 1.0;
      for (int i = 0; i <= order; ++i)
      {
        double sum = 0.0;
        for (int j = 0; i + j <= order; ++j)
        {
          sum += plane[i][j] * powers[j];
        }
        line[i] = static_cast<float>(sum / factorial);
        factorial *= i + 1;
      }
      const auto first = static_cast<float>(at(0, 0));
      const auto step = static_cast<float>(grid.Step[0] / local.Unit);
      for (int x = 0; x < grid.Count[0]; x += 8)
      {
        const Float8 place =
          first + step * (static_cast<float>(x) + Float8{ 0, 1, 2, 3, 4, 5, 6, 7 });
        Float8 value = Float8{} + line[order];
        for (int i = order; i-- > 0;)
        {
          value = value * place + line[i];
        }
        add(x, y, z, value);
      }
    }
  }
}
}
}

#endif
