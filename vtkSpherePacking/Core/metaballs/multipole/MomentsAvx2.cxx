// SPDX-License-Identifier: BSD-3-Clause
// Compiled for processors with AVX2 and FMA, see base/Simd.h.
#define SPHEREPACKING_ISA Avx2
#include "metaballs/multipole/NodeMoments.h"

#include "metaballs/multipole/MomentsAvx2.h"

namespace spherepacking
{
void SetMomentsAvx2(
  const ChargeTree& tree, const std::int32_t* nodes, int count, ClusterMoments& moments)
{
  SetMomentsImpl(tree, nodes, count, moments);
}
}
