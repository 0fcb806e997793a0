// SPDX-License-Identifier: BSD-3-Clause
/// A binary bounding volume hierarchy to be looked at: exact boxes, as few leaves as wanted. Rays
/// traverse the one of accel/Bvh.h.
#ifndef BoxTree_h
#define BoxTree_h

#include "base/ParallelFor.h"
#include "base/SphereArrays.h"
#include "base/HugeArray.h"
#include "accel/SphereBox.h"

#include <cstddef>
#include <vector>

namespace spherepacking
{
struct BoxNode
{
  Box Bounds;         ///< of its spheres, in double precision
  std::int64_t First; ///< in BoxTree::Ids
  std::int64_t Count;
  std::int64_t Second; ///< index of the second child; 0 for a leaf
  std::int32_t Depth;  ///< 0 for the root

  bool IsLeaf() const { return this->Second == 0; }
};

struct BoxTree
{
  std::vector<BoxNode> Nodes;  ///< depth first: the first child follows its parent
  HugeArray<std::int32_t> Ids; ///< of the spheres, leaf by leaf

  std::size_t Bytes() const
  {
    return this->Nodes.size() * sizeof(BoxNode) + this->Ids.size() * sizeof(std::int32_t);
  }

  /// How many boxes a random ray through the root's box goes through, plus how many spheres lie in
  /// those of them that are leaves: the chance of a convex box is its surface over the root's. 0 if
  /// the root has no surface, so that no random ray meets it.
  ///
  /// Sources: Goldsmith and Salmon, "Automatic Creation of Object Hierarchies for Ray Tracing"
  /// (1987); MacDonald and Booth, "Heuristics for Ray Tracing Using Space Subdivision" (1990).
  double SahCost() const;

  /// Sum of the volumes of the leaves over that of the root, overlaps counted as often as they
  /// occur; 0 if the root has no volume.
  double OccupiedFraction() const;
};

/// Splits by the surface-area heuristic, each time the leaf for which SahCost() falls most (or
/// rises least), until there are so many leaves or all have one sphere. `leaves` is 1 or more.
/// Spheres of radius 0 count, as points. The result does not depend on the threads.
BoxTree BuildBoxTreeOfLeaves(
  const SphereArrays& spheres, std::int64_t leaves, const ParallelFor& parallelFor);

/// Splits every node down to `depth`, 0 or more, or to single spheres.
BoxTree BuildBoxTreeOfDepth(const SphereArrays& spheres, int depth, const ParallelFor& parallelFor);
}

#endif
