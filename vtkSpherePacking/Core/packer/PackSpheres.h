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
  std::int64_t Count;     ///< of the spheres
  double MinimumRadius;   ///< above 0
  double Volume;          ///< of all spheres, or infinity
  std::uint64_t Seed = 0; ///< shifts the octree
};

/// Receives the number of spheres so far and their volume; returns whether to go on.
using PackingProgress = std::function<bool(std::int64_t count, double volume)>;

/// Fills the inside of a surface that is oriented outwards with spheres that overlap neither each
/// other nor the surface: again and again about the largest that fits, as ProtoSphere does.
/// Returns them largest first. The result does not depend on the number of threads.
///
/// ProtoSphere moves random points, prototypes, to maxima of the distance; here these are found by
/// branch and bound. Rounds take the leaves of an octree whose bounds of the clearance are highest.
/// A leaf that is large for its bound is split. From a small one Ascend() climbs to a maximum,
/// which becomes a sphere if its radius lies in the same band as the bound of the leaf, and if not,
/// the leaf is split, too. In gaps that are thin for their width, bounds stay far above all
/// clearances for long: after some rounds without a sphere, the largest that can be climbed to from
/// any leaf is taken.
/// Source: Weller and Zachmann, "ProtoSphere: a GPU-assisted prototype guided sphere packing
/// algorithm for arbitrary objects" (2010).
std::vector<PackedSphere> PackSpheres(const SurfaceMesh& mesh, const PackingGoal& goal,
  const ParallelFor& parallelFor, const PackingProgress& progress);
}

#endif
