// SPDX-License-Identifier: BSD-3-Clause
#ifndef BuildBvh_h
#define BuildBvh_h

#include "kernels/Bvh.h"
#include "kernels/SphereArrays.h"

#include <functional>

namespace spherepacking
{
/// Calls a function with 0 to count - 1, in any order and on as many threads as it likes.
using ParallelFor =
  std::function<void(std::int64_t count, const std::function<void(std::int64_t)>& work)>;

/// Spheres of radius 0, which no ray hits, are left out. The result does not depend on the threads.
Bvh BuildBvh(const SphereArrays& spheres, const ParallelFor& parallelFor);
}

#endif
