// SPDX-License-Identifier: BSD-3-Clause
#ifndef TracePathsAvx2_h
#define TracePathsAvx2_h

#include "light/TracePaths.h"

namespace spherepacking
{
// For processors with AVX2; the results are those without to the last bit.
void TracePathsAvx2(const Scene& scene, const CameraRays& rays, const PathLight& light,
  unsigned samples, const PathCells& cells, const Tile& tile, const PathPicture& picture);
}

#endif
