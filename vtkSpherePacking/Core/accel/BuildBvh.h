// SPDX-License-Identifier: BSD-3-Clause
#ifndef BuildBvh_h
#define BuildBvh_h

#include "accel/Bvh.h"
#include "base/ParallelFor.h"
#include "base/SphereArrays.h"

namespace spherepacking
{
/// Spheres of radius 0, which no ray hits, are left out. The result does not depend on the threads.
Bvh BuildBvh(const SphereArrays& spheres, const ParallelFor& parallelFor);
}

#endif
