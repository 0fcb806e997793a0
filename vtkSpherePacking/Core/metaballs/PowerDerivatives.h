// SPDX-License-Identifier: BSD-3-Clause
#ifndef PowerDerivatives_h
#define PowerDerivatives_h

#include "kernels/Simd.h"
#include "metaballs/MultiIndex.h"

namespace spherepacking
{
inline namespace SPHEREPACKING_ISA
{
constexpr float Factorial(int n)
{
  return n < 2 ? 1.0f : static_cast<float>(n) * Factorial(n - 1);
}

/// All derivatives of |R|^-Power up to a total degree, at unit vectors (x, y, z), eight at once.
///
/// The coefficients of its Taylor series obey a recurrence, which is that of the Gegenbauer
/// polynomials taken apart into monomials.
/// Source: Lindsay and Krasny, "A particle method and adaptive treecode for vortex sheet motion in
/// three-dimensional flow" (2001).
template <int Power>
inline void PowerDerivatives(
  const MultiIndex& index, const Float8& x, const Float8& y, const Float8& z, Float8* derivatives)
{
  constexpr float v = Power;
  const auto at = [&](int i, int j, int k) -> Float8& { return derivatives[index(i, j, k)]; };
  const Float8 zero{};
  at(0, 0, 0) = zero + 1.0f;
  for (int degree = 1; degree <= index.Order; ++degree)
  {
    const float n = static_cast<float>(degree);
    const float first = -(2.0f * n + v - 2.0f) / n;
    const float second = -(n + v - 2.0f) / n;
    for (int i = 0; i <= degree; ++i)
    {
      for (int j = 0; i + j <= degree; ++j)
      {
        const int k = degree - i - j;
        const Float8 one = (i > 0 ? x * at(i - 1, j, k) : zero) +
          (j > 0 ? y * at(i, j - 1, k) : zero) + (k > 0 ? z * at(i, j, k - 1) : zero);
        const Float8 two = (i > 1 ? at(i - 2, j, k) : zero) + (j > 1 ? at(i, j - 2, k) : zero) +
          (k > 1 ? at(i, j, k - 2) : zero);
        at(i, j, k) = first * one + second * two;
      }
    }
  }
  ForEachMonomial(index, [&](int i, int j, int k, int place)
    { derivatives[place] *= Factorial(i) * Factorial(j) * Factorial(k); });
}
}
}

#endif
