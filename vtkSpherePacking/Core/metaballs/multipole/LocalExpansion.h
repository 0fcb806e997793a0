// SPDX-License-Identifier: BSD-3-Clause
#ifndef LocalExpansion_h
#define LocalExpansion_h

#include "metaballs/multipole/AxisShifts.h"

#include <cstddef>

namespace spherepacking
{
/// A polynomial about a place: its derivatives there, in a unit of length.
struct LocalExpansion
{
  double Center[3];
  double Unit = 1.0;
  double Derivatives[MostKept] = {}; ///< in the order of a MultiIndex
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
inline void ShiftLocal(
  const MultiIndex& kept, const MultiIndex& all, const LocalExpansion& from, LocalExpansion& to)
{
  double away[3];
  for (int axis = 0; axis < 3; ++axis)
  {
    away[axis] = (to.Center[axis] - from.Center[axis]) / from.Unit;
  }
  double derivatives[MostKept];
  std::copy_n(from.Derivatives, kept.Count, derivatives);
  ShiftDerivatives(kept, all, away, derivatives);
  double shrinks[MostOrder + 1] = { 1.0 };
  for (int n = 1; n <= kept.Order; ++n)
  {
    shrinks[n] = shrinks[n - 1] * (to.Unit / from.Unit);
  }
  ForEachMonomial(kept, [&](int i, int j, int k, int place)
    { to.Derivatives[place] += derivatives[place] * shrinks[i + j + k]; });
}

/// A polynomial with all its derivatives, to be evaluated.
struct WholeExpansion
{
  double Unit;
  double Derivatives[MostMonomials]; ///< over the powers of `Unit`
};

inline WholeExpansion WholeOf(
  const MultiIndex& kept, const LocalExpansion& local, const MultiIndex& all)
{
  WholeExpansion whole;
  whole.Unit = local.Unit;
  Unfold(kept, local.Derivatives, all, whole.Derivatives);
  return whole;
}

/// Its derivative along an axis.
inline WholeExpansion DerivativeOf(const MultiIndex& all, const WholeExpansion& whole, int axis)
{
  WholeExpansion result;
  result.Unit = whole.Unit;
  ForEachMonomial(all,
    [&](int i, int j, int k, int place)
    {
      result.Derivatives[place] = i + j + k == all.Order
        ? 0.0
        : whole.Derivatives[all(i + (axis == 0), j + (axis == 1), k + (axis == 2))] / whole.Unit;
    });
  return result;
}

/// Calls add(x, y, z, eight values from x on) for all places of the grid, eight at once along x;
/// those beyond the last mean nothing.
template <typename Add>
inline void ForEachLocalValue(
  const MultiIndex& all, const WholeExpansion& whole, const LocalGrid& grid, Add add)
{
  const int order = all.Order;
  const auto at = [&](int axis, int i)
  { return (grid.First[axis] + i * grid.Step[axis]) / whole.Unit; };
  for (int z = 0; z < grid.Count[2]; ++z)
  {
    double plane[MostOrder + 1][MostOrder + 1];
    double power = 1.0;
    for (int k = 0; k <= order; ++k)
    {
      for (int j = 0; j + k <= order; ++j)
      {
        const double* row = whole.Derivatives + all.Rows[k][j];
        for (int i = 0; i + j + k <= order; ++i)
        {
          plane[j][i] = k == 0 ? row[i] : plane[j][i] + row[i] * power;
        }
      }
      power *= at(2, z) / (k + 1);
    }
    for (int y = 0; y < grid.Count[1]; ++y)
    {
      double sums[MostOrder + 1];
      power = 1.0;
      for (int j = 0; j <= order; ++j)
      {
        for (int i = 0; i + j <= order; ++i)
        {
          sums[i] = j == 0 ? plane[j][i] : sums[i] + plane[j][i] * power;
        }
        power *= at(1, y) / (j + 1);
      }
      float line[MostOrder + 1];
      double factorial = 1.0;
      for (int i = 0; i <= order; ++i)
      {
        line[i] = static_cast<float>(sums[i] / factorial);
        factorial *= i + 1;
      }
      const auto first = static_cast<float>(at(0, 0));
      const auto step = static_cast<float>(grid.Step[0] / whole.Unit);
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
