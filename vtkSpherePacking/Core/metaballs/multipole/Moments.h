// SPDX-License-Identifier: BSD-3-Clause
#ifndef Moments_h
#define Moments_h

#include "base/HugeArray.h"
#include "base/ParallelFor.h"
#include "metaballs/multipole/ChargeTree.h"
#include "metaballs/multipole/MultiIndex.h"

namespace spherepacking
{
/// Cartesian multipole moments of all nodes of a tree: sums over a node's charges of strength times
/// (-y)^m / m!, where m is a multi-index and y the charge's position relative to the node's centre,
/// divided by the node's radius. A node of radius 0 (coincident charges) has only the monopole.
struct ClusterMoments
{
  MultiIndex Reduced{ 0, 0 }; ///< of the moments
  MultiIndex Full{ 0, 0 };    ///< of the same order
  HugeArray<float> Values;    ///< Reduced.Count per node

  SPHEREPACKING_INLINE const float* operator[](std::int32_t node) const
  {
    return this->Values.data() + static_cast<std::size_t>(node) * this->Reduced.Count;
  }
  SPHEREPACKING_INLINE float* operator[](std::int32_t node)
  {
    return this->Values.data() + static_cast<std::size_t>(node) * this->Reduced.Count;
  }
};

/// The upward pass: moments of leaves from their charges (P2M), those of all others from their
/// children's (M2M).
ClusterMoments ComputeMoments(
  const ChargeTree& tree, const MultiIndex& reduced, const ParallelFor& parallelFor);
}

#endif
