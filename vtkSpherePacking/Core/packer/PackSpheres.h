// SPDX-License-Identifier: BSD-3-Clause
#ifndef PackSpheres_h
#define PackSpheres_h

#include "base/ParallelFor.h"
#include "packer/ClearanceTree.h"

#include <functional>

namespace spherepacking
{
/// When to stop, whichever comes first.
struct PackingGoal
{
  std::int64_t Count;     ///< spheres
  double LeastRadius;     ///< above 0
  double Volume;          ///< of all spheres, or infinity
  std::uint64_t Seed = 0; ///< where the octree lies
};

/// Is told how many spheres there are, and says whether to go on.
using PackingProgress = std::function<bool(std::int64_t count, double volume)>;

/// Fills the inside of a surface, whose triangles are turned outwards, with spheres that overlap
/// neither each other nor the surface: again and again about the largest that fits.
/// They are sorted, largest first. The result does not depend on the threads.
///
/// Leaves of an octree are split where the bound of the clearance is largest, as in a branch-and-
/// bound search, many at once. From small ones, the clearance is climbed; what is found becomes a
/// sphere if its radius lies in the band of bounds of its leaf. In gaps that are thin for their
/// width, bounds stay far above all clearances for long: after some time the best that can be
/// climbed to from any leaf is taken.
std::vector<PackedSphere> PackSpheres(const SurfaceMesh& mesh, const PackingGoal& goal,
  const ParallelFor& parallelFor, const PackingProgress& progress);
}

#endif
