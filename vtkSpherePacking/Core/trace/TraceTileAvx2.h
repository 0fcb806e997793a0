// SPDX-License-Identifier: BSD-3-Clause
#ifndef TraceTileAvx2_h
#define TraceTileAvx2_h

#include "trace/TraceTile.h"

namespace spherepacking
{
// For processors with AVX2; the results are those without to the last bit.
void TraceTileAvx2(const Scene& scene, const CameraRays& rays, const Double3& toEye, int samples,
  const Tile& tile, const Picture& picture);
Hit PrimaryHitAvx2(const Scene& scene, const Ray& ray);
}

#endif
