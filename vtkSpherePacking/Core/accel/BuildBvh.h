// SPDX-License-Identifier: BSD-3-Clause
#ifndef BuildBvh_h
#define BuildBvh_h

#include "accel/Bvh.h"
#include "base/ParallelFor.h"
#include "base/SphereArrays.h"

namespace spherepacking
{
/// Builds the hierarchy by the surface-area heuristic, without spheres of radius 0, which no ray
/// hits. The result does not depend on the threads.
Bvh BuildBvh(const SphereArrays& spheres, const ParallelFor& parallelFor);
}

#endif
