// SPDX-License-Identifier: BSD-3-Clause
/// Closest hits without a structure: every ray is tested against every sphere.
#ifndef TraceAll_h
#define TraceAll_h

#include "trace/RayBlock.h"
#include "base/SphereArrays.h"

namespace spherepacking
{
inline namespace SPHEREPACKING_ISA
{
template <typename RayT>
inline Hit FirstHit(const SphereArrays& spheres, const Ray& ray, const RayT& kind)
{
  const double inverseSquare = InverseSquare(ray);
  Hit hit;
  for (std::int64_t i = 0; i < spheres.Count; ++i)
  {
    const Sphere sphere = spheres[i];
    hit.Offer(kind.Hit(ray, sphere, inverseSquare, i), i, sphere);
  }
  return hit;
}

inline void TraceBlock(const SphereArrays& spheres, RayBlock& block)
{
  for (std::int64_t i = 0; i < spheres.Count; ++i)
  {
    block.Offer(spheres[i], MakeKey(i, 0), RayRectangle(), 0.0);
  }
}
}
}

#endif
