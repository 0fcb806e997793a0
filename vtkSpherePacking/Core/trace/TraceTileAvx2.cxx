// SPDX-License-Identifier: BSD-3-Clause
// Compiled for processors with AVX2. Names from here end in a namespace of their own, so that the
// linker never takes one of these functions for the one that runs everywhere.
#define SPHEREPACKING_ISA Avx2
#include "trace/TileTracer.h"

#include "trace/TraceTileAvx2.h"

namespace spherepacking
{
void TraceTileAvx2(const Scene& scene, const CameraRays& rays, const Double3& toEye, int samples,
  const Tile& tile, const Picture& picture)
{
  TraceTileImpl(scene, rays, toEye, samples, tile, picture);
}

Hit PrimaryHitAvx2(const Scene& scene, const Ray& ray)
{
  return PrimaryHitImpl(scene, ray);
}
}
