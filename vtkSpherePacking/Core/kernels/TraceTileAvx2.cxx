// SPDX-License-Identifier: BSD-3-Clause
// Compiled for processors with AVX2. Names from here end in a namespace of their own, so that the
// linker never takes one of these functions for the one that runs everywhere.
#define SPHEREPACKING_ISA Avx2
#include "kernels/PathTileKernel.h"

#include "kernels/TraceTileAvx2.h"

namespace spherepacking
{
void TraceTileAvx2(const Scene& scene, const CameraRays& rays, const Vector& toEye, int samples,
  const Tile& tile, const Picture& picture)
{
  TraceTileKernel(scene, rays, toEye, samples, tile, picture);
}

void TracePathsAvx2(const Scene& scene, const CameraRays& rays, const PathLight& light,
  unsigned samples, const PathCells& cells, const Tile& tile, const PathPicture& picture)
{
  TracePathsKernel(scene, rays, light, samples, cells, tile, picture);
}

Hit FirstHitAvx2(const Scene& scene, const Ray& ray)
{
  return FirstHitKernel(scene, ray, EverySurface());
}
}
