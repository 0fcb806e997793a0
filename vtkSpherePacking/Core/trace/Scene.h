// SPDX-License-Identifier: BSD-3-Clause
#ifndef Scene_h
#define Scene_h

#include "accel/Bvh.h"
#include "accel/GridTable.h"
#include "base/SphereArrays.h"
#include "trace/RaySphere.h"

namespace spherepacking
{
/// What rays are traced through: spheres, the structure that finds them, and their colours.
struct Scene
{
  SphereArrays Spheres;
  const Bvh* Hierarchy = nullptr;        ///< if any, else
  const GridTable* Table = nullptr;      ///< if any, else every ray is tested against every sphere
  const unsigned char* Colors = nullptr; ///< RGBA, four bytes per sphere
};

/// The closest hit of a ray, which may start inside spheres.
Hit FirstHit(const Scene& scene, const Ray& ray);
}

#endif
