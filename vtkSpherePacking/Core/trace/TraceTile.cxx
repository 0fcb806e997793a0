// SPDX-License-Identifier: BSD-3-Clause
#include "base/Dispatch.h"
#include "trace/TileTracer.h"
#include "trace/TraceTileAvx2.h"

namespace spherepacking
{
//------------------------------------------------------------------------------
void TraceTile(const Scene& scene, const CameraRays& rays, const Double3& toEye, int samples,
  const Tile& tile, const Picture& picture)
{
  SPHEREPACKING_DISPATCH(TraceTile)(scene, rays, toEye, samples, tile, picture);
}

//------------------------------------------------------------------------------
Hit FirstHit(const Scene& scene, const Ray& ray)
{
  return SPHEREPACKING_DISPATCH(PrimaryHit)(scene, ray);
}
}
