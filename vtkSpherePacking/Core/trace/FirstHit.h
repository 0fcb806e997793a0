// SPDX-License-Identifier: BSD-3-Clause
/// The closest hit, or any hit, of a ray through the structure of the scene, whichever it is.
#ifndef FirstHit_h
#define FirstHit_h

#include "trace/Scene.h"
#include "trace/TraceAll.h"
#include "trace/TraceBvhRay.h"
#include "trace/TraceGrid.h"

namespace spherepacking
{
inline namespace SPHEREPACKING_ISA
{
template <typename RayT>
inline Hit FirstHitImpl(const Scene& scene, const Ray& ray, const RayT& kind)
{
  return scene.Hierarchy ? FirstHit(*scene.Hierarchy, scene.Spheres, ray, kind)
    : scene.Table        ? FirstHit(*scene.Table, scene.Spheres, ray, kind)
                         : FirstHit(scene.Spheres, ray, kind);
}

/// What FirstHit() does, compiled once for each kind of processor.
inline Hit PrimaryHitImpl(const Scene& scene, const Ray& ray)
{
  return FirstHitImpl(scene, ray, PrimaryRay());
}
}
}

#endif
