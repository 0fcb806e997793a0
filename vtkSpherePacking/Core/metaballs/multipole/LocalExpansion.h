// SPDX-License-Identifier: BSD-3-Clause
#ifndef LocalExpansion_h
#define LocalExpansion_h

#include "metaballs/multipole/AxisShifts.h"

#include <cstddef>

namespace spherepacking
{
/// A local expansion: the Taylor polynomial of a field about a centre.
struct LocalExpansion
{
  double Center[3];
  double Unit = 1.0;                   ///< of length
  double Derivatives[MaxReduced] = {}; ///< at the centre, by a reduced index
};

/// A regular grid of points relative to the centre of an expansion.
struct LocalGrid
{
  double First[3];
  double Spacing[3];
  int Count[3]; ///< at most 512 along x, where points are computed in single precision
};

inline namespace SPHEREPACKING_ISA
{
/// L2L: adds an expansion to one about another centre and in another unit.
inline void ShiftLocal(
  const MultiIndex& reduced, const MultiIndex& full, const LocalExpansion& from, LocalExpansion& to)
{
  double shift[3];
  for (int axis = 0; axis < 3; ++axis)
  {
    shift[axis] = (to.Center[axis] - from.Center[axis]) / from.Unit;
  }
  double derivatives[MaxReduced];
  std::copy_n(from.Derivatives, reduced.Count, derivatives);
  ShiftDerivatives(reduced, full, shift, derivatives);
  double ratios[MaxOrder + 1] = { 1.0 };
  for (int n = 1; n <= reduced.Order; ++n)
  {
    ratios[n] = ratios[n - 1] * (to.Unit / from.Unit);
  }
  ForEachMonomial(reduced,
    [&](int i, int j, int k, int n) { to.Derivatives[n] += derivatives[n] * ratios[i + j + k]; });
}

/// A local expansion with the derivatives of a full index, for evaluation.
struct FullExpansion
{
  double Unit;
  double Derivatives[MaxFull]; ///< times the powers of `Unit`
};

inline FullExpansion FullExpansionOf(
  const MultiIndex& reduced, const LocalExpansion& local, const MultiIndex& full)
{
  FullExpansion result;
  result.Unit = local.Unit;
  RestoreDerivatives(reduced, local.Derivatives, full, result.Derivatives);
  return result;
}

/// The expansion of the partial derivative along an axis.
inline FullExpansion DerivativeOf(const MultiIndex& full, const FullExpansion& expansion, int axis)
{
  FullExpansion result;
  result.Unit = expansion.Unit;
  ForEachMonomial(full,
    [&](int i, int j, int k, int n)
    {
      result.Derivatives[n] = i + j + k == full.Order
        ? 0.0
        : expansion.Derivatives[full(i + (axis == 0), j + (axis == 1), k + (axis == 2))] /
          expansion.Unit;
    });
  return result;
}

/// L2P: calls add(x, y, z, values) with the values at eight points from (x, y, z) on along x, until
/// all points of the grid have had theirs; values beyond the end of a row are to be ignored.
///
/// A polynomial in three variables becomes one in x and y for each plane, one in x for each row,
/// and that is evaluated by Horner's rule: O(p) operations per point.
template <typename Add>
inline void EvaluateLocal(
  const MultiIndex& full, const FullExpansion& expansion, const LocalGrid& grid, Add add)
{
  const int order = full.Order;
  const auto at = [&](int axis, int i)
  { return (grid.First[axis] + i * grid.Spacing[axis]) / expansion.Unit; };
  for (int z = 0; z < grid.Count[2]; ++z)
  {
    double plane[MaxOrder + 1][MaxOrder + 1];
    double power = 1.0;
    for (int k = 0; k <= order; ++k)
    {
      for (int j = 0; j + k <= order; ++j)
      {
        const double* row = expansion.Derivatives + full.Rows[k][j];
        for (int i = 0; i + j + k <= order; ++i)
        {
          plane[j][i] = k == 0 ? row[i] : plane[j][i] + row[i] * power;
        }
      }
      power *= at(2, z) / (k + 1);
    }
    for (int y = 0; y < grid.Count[1]; ++y)
    {
      double sums[MaxOrder + 1];
      power = 1.0;
      for (int j = 0; j <= order; ++j)
      {
        for (int i = 0; i + j <= order; ++i)
        {
          sums[i] = j == 0 ? plane[j][i] : sums[i] + plane[j][i] * power;
        }
        power *= at(1, y) / (j + 1);
      }
      float line[MaxOrder + 1];
      double factorial = 1.0;
      for (int i = 0; i <= order; ++i)
      {
        line[i] = static_cast<float>(sums[i] / factorial);
        factorial *= i + 1;
      }
      const auto first = static_cast<float>(at(0, 0));
      const auto step = static_cast<float>(grid.Spacing[0] / expansion.Unit);
      for (int x = 0; x < grid.Count[0]; x += 8)
      {
        const Float8 point =
          first + step * (static_cast<float>(x) + Float8{ 0, 1, 2, 3, 4, 5, 6, 7 });
        Float8 value = Float8{} + line[order];
        for (int i = order; i-- > 0;)
        {
          value = value * point + line[i];
        }
        add(x, y, z, value);
      }
    }
  }
}
}
}

#endif
