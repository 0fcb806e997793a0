// SPDX-License-Identifier: BSD-3-Clause
#ifndef TranslationIndex_h
#define TranslationIndex_h

#include "metaballs/multipole/MultiIndex.h"

#include <vector>

namespace spherepacking
{
/// A step of the recurrence for the Taylor coefficients T of |R|^-power about a vector (x, y, z):
/// T[To] = FirstFactor (x T[OneLess[0]] + y T[OneLess[1]] + z T[OneLess[2]]) + SecondFactor
/// (T[TwoLess[0]] + T[TwoLess[1]] + T[TwoLess[2]]).
struct DerivativeStep
{
  float FirstFactor;
  float SecondFactor;
  int To;
  int OneLess[3]; ///< positions where the exponent of an axis is lower by one; by two:
  int TwoLess[3];
};

/// Tables for M2L translations of an order in a field that falls with |R|^-power.
struct TranslationIndex
{
  MultiIndex Reduced;     ///< of moments and local expansions
  MultiIndex Derivatives; ///< of |R|^-power: all sums of two multi-indices of `Reduced`

  /// From the coefficient T[0] = 1 at a unit vector to all others. Coefficients with a negative
  /// exponent are 0; their position is the one behind the last.
  ///
  /// The recurrence is that of the Gegenbauer polynomials, separated into monomials.
  /// Source: Lindsay and Krasny, "A particle method and adaptive treecode for vortex sheet motion
  /// in three-dimensional flow" (2001).
  std::vector<DerivativeStep> Steps;
  std::vector<float> Factorials; ///< i! j! k!, from Taylor coefficients to derivatives

  TranslationIndex(int power, int order);
};
}

#endif
