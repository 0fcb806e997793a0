// SPDX-License-Identifier: BSD-3-Clause
/// Expansions about another centre: shifts along x, y and z, one after the other.
///
/// A shift along one axis takes sums over its exponent alone, O(p^4) operations in all in place of
/// O(p^6), or O(p^3) in place of O(p^4) where only small exponents of z are kept. Neither a
/// polynomial of degree p nor moments up to that degree lose anything.
#ifndef AxisShifts_h
#define AxisShifts_h

#include "base/Simd.h"
#include "metaballs/multipole/MultiIndex.h"

namespace spherepacking
{
inline namespace SPHEREPACKING_ISA
{
/// s^n / n! up to n = order.
template <typename Real>
inline void ScaledPowers(int order, const Real& s, Real* powers)
{
  powers[0] = Real{} + 1;
  for (int n = 1; n <= order; ++n)
  {
    powers[n] = powers[n - 1] * s / static_cast<float>(n);
  }
}

/// The derivatives of larger exponents of z than are kept, which follow from those.
template <typename Real>
inline void Unfold(const MultiIndex& kept, const Real* derivatives, const MultiIndex& all, Real* to)
{
  ForEachMonomial(all,
    [&](int i, int j, int k, int place)
    {
      to[place] = k <= kept.Top ? derivatives[kept(i, j, k)]
                                : -to[all(i + 2, j, k - 2)] - to[all(i, j + 2, k - 2)];
    });
}

/// Adds moments of larger exponents of z than are kept to those that are.
template <typename Real>
inline void Fold(const MultiIndex& all, Real* from, const MultiIndex& kept, Real* moments)
{
  for (int k = all.Top; k > kept.Top; --k)
  {
    for (int j = 0; j + k <= all.Order; ++j)
    {
      for (int i = 0; i + j + k <= all.Order; ++i)
      {
        const Real moment = from[all(i, j, k)];
        from[all(i + 2, j, k - 2)] -= moment;
        from[all(i, j + 2, k - 2)] -= moment;
      }
    }
  }
  ForEachMonomial(
    kept, [&](int i, int j, int k, int place) { moments[place] = from[all(i, j, k)]; });
}

/// Derivatives at a place that is away by (x, y, z). `all` has all exponents of z.
template <typename Real>
inline void ShiftDerivatives(
  const MultiIndex& kept, const MultiIndex& all, const Real (&away)[3], Real* derivatives)
{
  const int order = kept.Order;
  Real powers[3][MostOrder + 1];
  for (int axis = 0; axis < 3; ++axis)
  {
    ScaledPowers(order, away[axis], powers[axis]);
  }
  Real whole[MostMonomials];
  Unfold(kept, derivatives, all, whole);
  ForEachMonomial(kept,
    [&](int i, int j, int k, int place)
    {
      Real sum = whole[all(i, j, k)];
      for (int c = 1; i + j + k + c <= order; ++c)
      {
        sum += whole[all(i, j, k + c)] * powers[2][c];
      }
      derivatives[place] = sum;
    });
  // In place: what is read has not been written.
  ForEachMonomial(kept,
    [&](int i, int j, int k, int place)
    {
      for (int b = 1; i + j + k + b <= order; ++b)
      {
        derivatives[place] += derivatives[kept(i, j + b, k)] * powers[1][b];
      }
    });
  ForEachMonomial(kept,
    [&](int i, int j, int k, int place)
    {
      for (int a = 1; i + j + k + a <= order; ++a)
      {
        derivatives[place] += derivatives[place + a] * powers[0][a];
      }
    });
}

/// Moments about a centre from which the former one is away by (x, y, z), of charges at -y: those
/// of a ClusterMoments.
template <typename Real>
inline void ShiftMoments(
  const MultiIndex& kept, const MultiIndex& all, const Real (&away)[3], Real* moments)
{
  const int order = kept.Order;
  Real powers[3][MostOrder + 1];
  for (int axis = 0; axis < 3; ++axis)
  {
    ScaledPowers(order, away[axis], powers[axis]);
  }
  Real whole[MostMonomials];
  ForEachMonomial(all,
    [&](int i, int j, int k, int place)
    {
      Real sum{};
      for (int c = std::max(0, k - kept.Top); c <= k; ++c)
      {
        sum += moments[kept(i, j, k - c)] * powers[2][c];
      }
      whole[place] = sum;
    });
  Fold(all, whole, kept, moments);
  for (int k = 0; k <= kept.Top; ++k)
  {
    for (int j = order - k; j >= 0; --j)
    {
      for (int i = order - j - k; i >= 0; --i)
      {
        Real& moment = moments[kept(i, j, k)];
        for (int b = 1; b <= j; ++b)
        {
          moment += moments[kept(i, j - b, k)] * powers[1][b];
        }
      }
    }
    for (int j = 0; j + k <= order; ++j)
    {
      Real* row = moments + kept.Rows[k][j];
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
