// SPDX-License-Identifier: BSD-3-Clause
#ifndef SphereBox_h
#define SphereBox_h

#include "base/Box.h"
#include "base/Sphere.h"

#include <algorithm>

namespace spherepacking
{
/// Whether a ball and a box have a point in common, by the distance from the centre to the box.
///
/// Source: Arvo, "A Simple Method for Box-Sphere Intersection Testing", Graphics Gems (1990).
/// Scaled by the radius, so that neither very small nor very large lengths leave the range of
/// squares.
inline bool Touches(const Sphere& sphere, const Box& box)
{
  const double center[3] = { sphere.X, sphere.Y, sphere.Z };
  double squared = 0.0;
  for (int axis = 0; axis < 3; ++axis)
  {
    const double outside =
      std::max({ box.Low[axis] - center[axis], center[axis] - box.High[axis], 0.0 });
    if (outside > sphere.R)
    {
      return false;
    }
    const double ratio = sphere.R > 0.0 ? outside / sphere.R : 0.0;
    squared += ratio * ratio;
  }
  return squared <= 1.0;
}
}

#endif
