// SPDX-License-Identifier: BSD-3-Clause
#ifndef Moments_h
#define Moments_h

#include "base/ParallelFor.h"
#include "base/HugeArray.h"
#include "metaballs/multipole/ChargeTree.h"
#include "metaballs/field/FieldGrid.h"
#include "metaballs/multipole/MultiIndex.h"

namespace spherepacking
{
/// Of each node, sum over its charges of strength (-y)^m / m!, where y is the charge's place from
/// the node's centre over the node's radius. Charges at one place, a node of radius 0, have none
/// but the first.
struct ClusterMoments
{
  MultiIndex Kept{ 0, 0 };
  MultiIndex All{ 0, 0 };  ///< to the same order, with all exponents of z
  HugeArray<float> Values; ///< Kept.Count of one node after the other

  SPHEREPACKING_INLINE const float* operator[](std::int32_t node) const
  {
    return this->Values.data() + static_cast<std::size_t>(node) * this->Kept.Count;
  }
  SPHEREPACKING_INLINE float* operator[](std::int32_t node)
  {
    return this->Values.data() + static_cast<std::size_t>(node) * this->Kept.Count;
  }
};

ClusterMoments ComputeMoments(
  const ChargeTree& tree, const MultiIndex& kept, const ParallelFor& parallelFor);
}

#endif
