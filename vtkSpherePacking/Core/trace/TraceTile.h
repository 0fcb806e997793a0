// SPDX-License-Identifier: BSD-3-Clause
/// Casts the rays of a tile of a camera's picture through the structure of the scene.
#ifndef TraceTile_h
#define TraceTile_h

#include "trace/CameraRays.h"
#include "trace/Scene.h"

namespace spherepacking
{
/// Where a picture goes: rows from the bottom, `Width` pixels each.
struct Picture
{
  int Width;
  int Height;
  unsigned char* Color; ///< RGBA, 0 where nothing is hit
  float* Depth;         ///< infinite where nothing is hit
  float* Normal;        ///< x, y, z
  long long* Id;        ///< -1 where nothing is hit
};

struct Tile
{
  int X;
  int Y;
  int Width;
  int Height;
};

/// Colours are the mean of samples x samples rays a pixel, on a regular grid, lit from the eye in
/// the direction `toEye` (a unit vector); all else is of the ray through the pixel's middle.
void TraceTile(const Scene& scene, const CameraRays& rays, const Vector& toEye, int samples,
  const Tile& tile, const Picture& picture);
}

#endif
