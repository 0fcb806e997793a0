// SPDX-License-Identifier: BSD-3-Clause
#ifndef MomentsAvx2_h
#define MomentsAvx2_h

#include "metaballs/multipole/Moments.h"

namespace spherepacking
{
/// SetMomentsImpl() for processors with AVX2 and FMA; the results differ by rounding.
void SetMomentsAvx2(
  const ChargeTree& tree, const std::int32_t* nodes, int count, ClusterMoments& moments);
}

#endif
