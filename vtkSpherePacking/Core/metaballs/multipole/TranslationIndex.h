// SPDX-License-Identifier: BSD-3-Clause
#ifndef TranslationIndex_h
#define TranslationIndex_h

#include "metaballs/multipole/MultiIndex.h"

#include <vector>

namespace spherepacking
{
/// Sets the coefficient T[To] of a Taylor series to First times the sum of x, y and z times those
/// at One, plus Second times the sum of those at Two.
struct DerivativeStep
{
  float First;
  float Second;
  int To;
  int One[3];
  int Two[3];
};

/// What translations to some order need to know, of a field that falls with |R|^-power.
struct TranslationIndex
{
  MultiIndex Kept; ///< of moments and expansions
  MultiIndex Sums; ///< of derivatives: all exponents that are sums of two that are kept

  /// How Taylor's series of |R|^-power about a unit vector follows from its first coefficient, 1.
  /// Those that there are not lie behind the last, and are to be 0.
  ///
  /// The recurrence is that of the Gegenbauer polynomials taken apart into monomials.
  /// Source: Lindsay and Krasny, "A particle method and adaptive treecode for vortex sheet motion
  /// in three-dimensional flow" (2001).
  std::vector<DerivativeStep> Steps;
  std::vector<float> Factorials; ///< derivatives over coefficients, i! j! k!

  TranslationIndex(int power, int order);
};
}

#endif
