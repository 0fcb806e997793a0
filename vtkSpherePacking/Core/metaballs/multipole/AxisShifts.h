// SPDX-License-Identifier: BSD-3-Clause
/// Expansions about another centre: M2M for moments, L2L for derivatives.
///
/// A shift by (x, y, z) is done as three shifts along the axes, each of which takes sums over the
/// exponent of its axis alone: O(p^4) operations in place of O(p^6), or O(p^3) in place of O(p^4)
/// for a reduced index. Neither loses anything: a polynomial of degree p stays one, and moments up
/// to the degree p depend on those up to p alone.
#ifndef AxisShifts_h
#define AxisShifts_h

#include "base/Simd.h"
#include "metaballs/multipole/MultiIndex.h"

namespace spherepacking
{
inline namespace SPHEREPACKING_ISA
{
/// s^n / n! for n <= order.
template <typename Real>
inline void ScaledPowers(int order, const Real& s, Real* powers)
{
  powers[0] = Real{} + 1;
  for (int n = 1; n <= order; ++n)
  {
    powers[n] = powers[n - 1] * s / static_cast<float>(n);
  }
}

/// The derivatives of a full index from those of a reduced one, by Laplace's equation.
template <typename Real>
inline void RestoreDerivatives(
  const MultiIndex& reduced, const Real* derivatives, const MultiIndex& full, Real* to)
{
  ForEachMonomial(full,
    [&](int i, int j, int k, int n)
    {
      to[n] = k <= reduced.ZDegree ? derivatives[reduced(i, j, k)]
                                   : -to[full(i + 2, j, k - 2)] - to[full(i, j + 2, k - 2)];
    });
}

/// The moments of a reduced index from those of a full one, which are overwritten.
template <typename Real>
inline void ReduceMoments(const MultiIndex& full, Real* from, const MultiIndex& reduced, Real* to)
{
  for (int k = full.ZDegree; k > reduced.ZDegree; --k)
  {
    for (int j = 0; j + k <= full.Order; ++j)
    {
      for (int i = 0; i + j + k <= full.Order; ++i)
      {
        const Real moment = from[full(i, j, k)];
        from[full(i + 2, j, k - 2)] -= moment;
        from[full(i, j + 2, k - 2)] -= moment;
      }
    }
  }
  ForEachMonomial(reduced, [&](int i, int j, int k, int n) { to[n] = from[full(i, j, k)]; });
}

/// L2L: derivatives of a polynomial at the former centre plus `shift`.
template <typename Real>
inline void ShiftDerivatives(
  const MultiIndex& reduced, const MultiIndex& full, const Real (&shift)[3], Real* derivatives)
{
  const int order = reduced.Order;
  Real powers[3][MaxOrder + 1];
  for (int axis = 0; axis < 3; ++axis)
  {
    ScaledPowers(order, shift[axis], powers[axis]);
  }
  Real restored[MaxFull];
  RestoreDerivatives(reduced, derivatives, full, restored);
  ForEachMonomial(reduced,
    [&](int i, int j, int k, int n)
    {
      Real sum = restored[full(i, j, k)];
      for (int c = 1; i + j + k + c <= order; ++c)
      {
        sum += restored[full(i, j, k + c)] * powers[2][c];
      }
      derivatives[n] = sum;
    });
  // In place, upwards: what is read has not been shifted yet.
  ForEachMonomial(reduced,
    [&](int i, int j, int k, int n)
    {
      for (int b = 1; i + j + k + b <= order; ++b)
      {
        derivatives[n] += derivatives[reduced(i, j + b, k)] * powers[1][b];
      }
    });
  ForEachMonomial(reduced,
    [&](int i, int j, int k, int n)
    {
      for (int a = 1; i + j + k + a <= order; ++a)
      {
        derivatives[n] += derivatives[n + a] * powers[0][a];
      }
    });
}

/// M2M: moments about another centre. As they are those of -y, see ClusterMoments, `shift` is the
/// new centre minus the former one.
template <typename Real>
inline void ShiftMoments(
  const MultiIndex& reduced, const MultiIndex& full, const Real (&shift)[3], Real* moments)
{
  const int order = reduced.Order;
  Real powers[3][MaxOrder + 1];
  for (int axis = 0; axis < 3; ++axis)
  {
    ScaledPowers(order, shift[axis], powers[axis]);
  }
  Real shifted[MaxFull];
  ForEachMonomial(full,
    [&](int i, int j, int k, int n)
    {
      Real sum{};
      for (int c = std::max(0, k - reduced.ZDegree); c <= k; ++c)
      {
        sum += moments[reduced(i, j, k - c)] * powers[2][c];
      }
      shifted[n] = sum;
    });
  ReduceMoments(full, shifted, reduced, moments);
  // In place, downwards.
  for (int k = 0; k <= reduced.ZDegree; ++k)
  {
    for (int j = order - k; j >= 0; --j)
    {
      for (int i = order - j - k; i >= 0; --i)
      {
        Real& moment = moments[reduced(i, j, k)];
        for (int b = 1; b <= j; ++b)
        {
          moment += moments[reduced(i, j - b, k)] * powers[1][b];
        }
      }
    }
    for (int j = 0; j + k <= order; ++j)
    {
      Real* row = moments + reduced.Rows[k][j];
      for (int i = order - j - k; i >= 0; --i)
      {
        for (int a = 1; a <= i; ++a)
        {
          row[i] += row[i - a] * powers[0][a];
        }
      }
    }
  }
}
}
}

#endif
