// SPDX-License-Identifier: BSD-3-Clause
#include "kernels/PathTileKernel.h"
#include "kernels/Processor.h"

#if defined(SPHEREPACKING_HAS_AVX2)
#include "kernels/TraceTileAvx2.h"
#endif

namespace spherepacking
{
//------------------------------------------------------------------------------
void TraceTile(const Scene& scene, const CameraRays& rays, const Vector& toEye, int samples,
  const Tile& tile, const Picture& picture)
{
#if defined(SPHEREPACKING_HAS_AVX2)
  if (HasAvx2())
  {
    TraceTileAvx2(scene, rays, toEye, samples, tile, picture);
    return;
  }
#endif
  TraceTileKernel(scene, rays, toEye, samples, tile, picture);
}

//------------------------------------------------------------------------------
void TracePaths(const Scene& scene, const CameraRays& rays, const PathLight& light,
  unsigned samples, const PathCells& cells, const Tile& tile, const PathPicture& picture)
{
#if defined(SPHEREPACKING_HAS_AVX2)
  if (HasAvx2())
  {
    TracePathsAvx2(scene, rays, light, samples, cells, tile, picture);
    return;
  }
#endif
  TracePathsKernel(scene, rays, light, samples, cells, tile, picture);
}

//------------------------------------------------------------------------------
Hit FirstHit(const Scene& scene, const Ray& ray)
{
#if defined(SPHEREPACKING_HAS_AVX2)
  if (HasAvx2())
  {
    return FirstHitAvx2(scene, ray);
  }
#endif
  return FirstHitKernel(scene, ray, EverySurface());
}
}
