// SPDX-License-Identifier: BSD-3-Clause
#include "metaballs/multipole/Multipoles.h"

#include "metaballs/field/Blobs.h"

#include <algorithm>
#include <cmath>

namespace spherepacking
{
namespace
{
// Bound for the rounding errors of direct summation in single precision, see BlockSum.h.
constexpr double Rounding = 1e-5;
// Part of the error that truncation may use; the rest is for rounding in expansions: the monomials
// of degree n add up to at most (1 + sqrt(2))^n t^n, and t^(p + 1) is about the error, so 2^-24 of
// them is below a tenth of it.
constexpr double Truncation = 0.9;

// The order of the moments, tuned for speed: with a higher one more clusters are far enough, but
// each costs more.
int OrderOf(int power, double relativeError)
{
  const double order = std::round((power == 1 ? 9.0 : 3.0) - 2.0 * std::log10(relativeError));
  return static_cast<int>(std::min(std::max(order, 2.0), static_cast<double>(MaxOrderOf(power))));
}
}

//------------------------------------------------------------------------------
Multipoles ComputeMultipoles(
  const ChargeTree& tree, int power, double relativeError, const ParallelFor& parallelFor)
{
  Multipoles multipoles;
  multipoles.TruncationError = Truncation * relativeError - Rounding;
  multipoles.Estimate = relativeError >= EstimateError + Rounding;
  const int order = OrderOf(power, relativeError);
  for (int i = 0; i <= order; ++i)
  {
    multipoles.Indices.emplace_back(power, i);
  }
  multipoles.Moments = ComputeMoments(tree, multipoles.Indices.back().Reduced, parallelFor);
  multipoles.Zeros.assign(MaxReduced, 0.0f);
  return multipoles;
}
}
