// SPDX-License-Identifier: BSD-3-Clause
// Compiled for processors with AVX2, see trace/TraceTileAvx2.cxx.
#define SPHEREPACKING_ISA Avx2
#include "light/PathTileTracer.h"

#include "light/TracePathsAvx2.h"

namespace spherepacking
{
void TracePathsAvx2(const Scene& scene, const CameraRays& rays, const PathLight& light,
  unsigned samples, const PathCells& cells, const Tile& tile, const PathPicture& picture)
{
  TracePathsImpl(scene, rays, light, samples, cells, tile, picture);
}
}
