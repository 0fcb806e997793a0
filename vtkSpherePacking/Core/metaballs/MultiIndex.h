// SPDX-License-Identifier: BSD-3-Clause
#ifndef MultiIndex_h
#define MultiIndex_h

namespace spherepacking
{
/// Largest total degree of the expansions.
constexpr int MostOrder = 9;

/// Number of monomials x^i y^j z^k with i + j + k <= order.
constexpr int CountMonomials(int order)
{
  return (order + 1) * (order + 2) * (order + 3) / 6;
}

constexpr int MostMonomials = CountMonomials(MostOrder);

/// Where the coefficient of x^i y^j z^k lies: those of equal i and j side by side, by k.
struct MultiIndex
{
  int Order = 0;
  int Count = 0;
  int Rows[MostOrder + 1][MostOrder + 1] = {}; ///< of i and j, where k = 0 lies

  constexpr explicit MultiIndex(int order)
    : Order(order)
  {
    for (int i = 0; i <= order; ++i)
    {
      for (int j = 0; i + j <= order; ++j)
      {
        this->Rows[i][j] = this->Count;
        this->Count += order - i - j + 1;
      }
    }
  }

  constexpr __attribute__((always_inline)) int operator()(int i, int j, int k) const
  {
    return this->Rows[i][j] + k;
  }
};

/// Calls visit(i, j, k, place) for all coefficients in the order in which they lie.
template <typename Visit>
inline void ForEachMonomial(const MultiIndex& index, Visit visit)
{
  int place = 0;
  for (int i = 0; i <= index.Order; ++i)
  {
    for (int j = 0; i + j <= index.Order; ++j)
    {
      for (int k = 0; i + j + k <= index.Order; ++k)
      {
        visit(i, j, k, place++);
      }
    }
  }
}
}

#endif
