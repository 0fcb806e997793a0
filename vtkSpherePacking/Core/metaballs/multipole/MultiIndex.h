// SPDX-License-Identifier: BSD-3-Clause
/// Coefficients of polynomials in three variables, and which of them are kept.
///
/// Taylor's series of q / d about the places of charges and about those of a grid have terms
/// moment(i, j, k) times the derivative of 1 / d by x^i y^j z^k. As 1 / d obeys Laplace's equation,
///
///   d^2/dz^2 = -d^2/dx^2 - d^2/dy^2,
///
/// derivatives with k >= 2 follow from the others, and a moment with k >= 2 may be added, with the
/// sign changed, to those at (i + 2, j, k - 2) and (i, j + 2, k - 2). So only those with k <= 1 are
/// kept, (p + 1)^2 for the order p in place of (p + 1) (p + 2) (p + 3) / 6. For q / d^2 all are.
///
/// Source: Hinsen and Felderhof, "Reduced description of electric multipole potential in Cartesian
/// coordinates" (1992).
#ifndef MultiIndex_h
#define MultiIndex_h

#include <algorithm>

namespace spherepacking
{
/// Largest total degree of the expansions of a field that falls with a power of the distance.
constexpr int MostOrderOf(int power)
{
  return power == 1 ? 15 : 9;
}

/// Largest exponent of z that is kept there.
constexpr int TopOf(int power, int order)
{
  return power == 1 ? std::min(1, order) : order;
}

constexpr int MostOrder = std::max(MostOrderOf(1), MostOrderOf(2));

/// Where the coefficient of x^i y^j z^k lies, for i + j + k <= Order and k <= Top: those of equal j
/// and k side by side, by i.
struct MultiIndex
{
  int Order = 0;
  int Top = 0;
  int Count = 0;
  int Rows[MostOrder + 1][MostOrder + 1] = {}; ///< of k and j, where i = 0 lies

  constexpr MultiIndex(int order, int top)
    : Order(order)
    , Top(std::min(top, order))
  {
    for (int k = 0; k <= this->Top; ++k)
    {
      for (int j = 0; j + k <= order; ++j)
      {
        this->Rows[k][j] = this->Count;
        this->Count += order - j - k + 1;
      }
    }
  }

  constexpr __attribute__((always_inline)) int operator()(int i, int j, int k) const
  {
    return this->Rows[k][j] + i;
  }
};

constexpr int CountMonomials(int order, int top)
{
  return MultiIndex(order, top).Count;
}

/// Sizes of the largest: of those that are kept, of their sums, of all.
constexpr int MostKept =
  std::max(CountMonomials(MostOrderOf(1), 1), CountMonomials(MostOrderOf(2), MostOrderOf(2)));
constexpr int MostSums =
  std::max(CountMonomials(MostOrderOf(1), 2), CountMonomials(MostOrderOf(2), MostOrderOf(2)));
constexpr int MostMonomials = CountMonomials(MostOrder, MostOrder);

/// Calls visit(i, j, k, place) for all coefficients in the order in which they lie.
template <typename Visit>
inline __attribute__((always_inline)) void ForEachMonomial(const MultiIndex& index, Visit visit)
{
  int place = 0;
  for (int k = 0; k <= index.Top; ++k)
  {
    for (int j = 0; j + k <= index.Order; ++j)
    {
      for (int i = 0; i + j + k <= index.Order; ++i)
      {
        visit(i, j, k, place++);
      }
    }
  }
}
}

#endif
