// SPDX-License-Identifier: BSD-3-Clause
#ifndef Multipoles_h
#define Multipoles_h

#include "metaballs/multipole/Moments.h"
#include "metaballs/multipole/TranslationIndex.h"

#include <vector>

namespace spherepacking
{
/// The multipole expansions of a charge tree, and how accurate a sum that uses them has to be.
struct Multipoles
{
  double TruncationError = 0.0; ///< relative error that the field of a cluster may have
  bool Estimate = false;        ///< whether direct summation may have the error EstimateError
  ClusterMoments Moments;
  std::vector<TranslationIndex> Indices; ///< of all orders up to that of the moments
  std::vector<float> Zeros;              ///< moments of a cluster without charges
};

/// Of the kernel r^power / d^power, for sums whose relative error is at most `relativeError`, which
/// is above 1e-5.
Multipoles ComputeMultipoles(
  const ChargeTree& tree, int power, double relativeError, const ParallelFor& parallelFor);
}

#endif
