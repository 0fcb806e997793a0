// SPDX-License-Identifier: BSD-3-Clause
#include "base/Dispatch.h"
#include "light/PathTileTracer.h"
#include "light/TracePathsAvx2.h"

namespace spherepacking
{
void TracePaths(const Scene& scene, const CameraRays& rays, const PathLight& light,
  unsigned samples, const PathCells& cells, const Tile& tile, const PathPicture& picture)
{
  SPHEREPACKING_DISPATCH(TracePaths)(scene, rays, light, samples, cells, tile, picture);
}
}
