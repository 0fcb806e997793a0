// SPDX-License-Identifier: BSD-3-Clause
/// Casts the rays of a tile of a camera's picture through the structure of the scene.
#ifndef TraceTile_h
#define TraceTile_h

#include "trace/CameraRays.h"
#include "trace/Scene.h"

namespace spherepacking
{
/// What a pixel shows where no sphere is hit; colour and normal are 0.
namespace Miss
{
constexpr long long Id = -1;
constexpr float Depth = std::numeric_limits<float>::infinity();
}

/// Where a picture goes: rows from the bottom, `Width` pixels each.
struct Picture
{
  int Width;
  int Height;
  unsigned char* Color; ///< RGBA
  float* Depth;
  float* Normal; ///< x, y, z
  long long* Id;
};

struct Tile
{
  int X;
  int Y;
  int Width;
  int Height;
};

/// Colours are the mean of samples x samples rays per pixel, on a regular grid, lit by a headlight
/// in the direction `toEye` (a unit vector); all else is of the ray through the pixel's middle.
void TraceTile(const Scene& scene, const CameraRays& rays, const Double3& toEye, int samples,
  const Tile& tile, const Picture& picture);
}

#endif
