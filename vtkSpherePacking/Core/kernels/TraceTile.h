// SPDX-License-Identifier: BSD-3-Clause
/// Traces a tile of a camera's picture, or one ray, through the structure that was chosen.
#ifndef TraceTile_h
#define TraceTile_h

#include "kernels/Bvh.h"
#include "kernels/CameraRays.h"
#include "kernels/GridTable.h"
#include "kernels/SphereArrays.h"

namespace spherepacking
{
/// Spheres, how they are found and what colour they have.
struct Scene
{
  SphereArrays Spheres;
  const Bvh* Hierarchy = nullptr;        ///< if any, else
  const GridTable* Table = nullptr;      ///< if any, else every ray is tested against every sphere
  const unsigned char* Colors = nullptr; ///< RGBA, four bytes a sphere
};

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

Hit FirstHit(const Scene& scene, const Ray& ray);
}

#endif
