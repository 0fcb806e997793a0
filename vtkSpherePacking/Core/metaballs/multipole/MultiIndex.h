// SPDX-License-Identifier: BSD-3-Clause
/// Multi-indices (i, j, k) of polynomials in three variables: which coefficients are stored, and
/// where.
///
/// The Taylor series of q / d about the centre of a cluster and about that of a block of points
/// have terms moment(i, j, k) times the derivative of 1 / d by x^i y^j z^k. As 1 / d is harmonic,
///
///   d^2/dz^2 = -d^2/dx^2 - d^2/dy^2,
///
/// derivatives with k >= 2 follow from those with k <= 1, and a moment with k >= 2 may be
/// subtracted from those at (i + 2, j, k - 2) and (i, j + 2, k - 2) instead of being stored. For
/// the order p a reduced index has k <= 1 alone, (p + 1)^2 coefficients, and a full index has all
/// (p + 1) (p + 2) (p + 3) / 6. As 1 / d^2 is not harmonic, both are the same for that.
///
/// Source: Hinsen and Felderhof, "Reduced description of electric multipole potential in Cartesian
/// coordinates" (1992).
#ifndef MultiIndex_h
#define MultiIndex_h

#include "base/Simd.h"

#include <algorithm>

namespace spherepacking
{
/// Highest order, which is the total degree, of the expansions of a field that falls with d^-power.
constexpr int MaxOrderOf(int power)
{
  return power == 1 ? 15 : 9;
}

/// Highest degree in z of its reduced expansions.
constexpr int ZDegreeOf(int power, int order)
{
  return power == 1 ? std::min(1, order) : order;
}

constexpr int MaxOrder = std::max(MaxOrderOf(1), MaxOrderOf(2));

/// Position of the coefficient of x^i y^j z^k in an array, for i + j + k <= Order and k <= ZDegree:
/// rows of equal j and k, by i.
struct MultiIndex
{
  int Order = 0;
  int ZDegree = 0;
  int Count = 0;
  int Rows[MaxOrder + 1][MaxOrder + 1] = {}; ///< positions of (0, j, k), by k and j

  constexpr MultiIndex(int order, int zDegree)
    : Order(order)
    , ZDegree(std::min(zDegree, order))
  {
    for (int k = 0; k <= this->ZDegree; ++k)
    {
      for (int j = 0; j + k <= order; ++j)
      {
        this->Rows[k][j] = this->Count;
        this->Count += order - j - k + 1;
      }
    }
  }

  constexpr SPHEREPACKING_INLINE int operator()(int i, int j, int k) const
  {
    return this->Rows[k][j] + i;
  }
};

constexpr int CountMonomials(int order, int zDegree)
{
  return MultiIndex(order, zDegree).Count;
}

/// Most coefficients of a reduced index, of all sums of two multi-indices of a reduced index, and
/// of a full index.
constexpr int MaxReduced =
  std::max(CountMonomials(MaxOrderOf(1), 1), CountMonomials(MaxOrderOf(2), MaxOrderOf(2)));
constexpr int MaxSums =
  std::max(CountMonomials(MaxOrderOf(1), 2), CountMonomials(MaxOrderOf(2), MaxOrderOf(2)));
constexpr int MaxFull = CountMonomials(MaxOrder, MaxOrder);

/// Calls visit(i, j, k, position) for all coefficients, by position.
template <typename Visit>
SPHEREPACKING_INLINE void ForEachMonomial(const MultiIndex& index, Visit visit)
{
  int position = 0;
  for (int k = 0; k <= index.ZDegree; ++k)
  {
    for (int j = 0; j + k <= index.Order; ++j)
    {
      for (int i = 0; i + j + k <= index.Order; ++i)
      {
        visit(i, j, k, position++);
      }
    }
  }
}
}

#endif
