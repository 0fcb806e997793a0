// SPDX-License-Identifier: BSD-3-Clause
#ifndef TouchingBall_h
#define TouchingBall_h

#include "packer/TriangleTree.h"

namespace spherepacking
{
/// The middle of the largest ball that lies within the surface, touches it at the point that is
/// nearest to a place, and has no larger radius than `most`.
///
/// The ball shrinks until nothing of the surface is in it, each time so that it touches what was
/// nearest to its middle.
/// Source: Ma, Bae and Choi, "3D medial axis point approximation using nearest neighbors and the
/// normal field" (2012).
inline Vector3 TouchingBall(const TriangleTree& surface, const Vector3& place, double most)
{
  constexpr int steps = 30;
  double distance = 1e300;
  TriangleTree::Nearest touched;
  surface.Closest(place, distance, touched);
  const Vector3 inward = -1.0 * surface.NormalOf(touched.Triangle);
  double radius = most;
  for (int i = 0; i < steps; ++i)
  {
    const Vector3 middle = touched.Point + radius * inward;
    distance = radius * (1.0 - 1e-6);
    TriangleTree::Nearest nearest;
    if (!surface.Closest(middle, distance, nearest))
    {
      break;
    }
    const Vector3 way = nearest.Point - touched.Point;
    const double ahead = Dot(way, inward);
    // What is not ahead is a neighbour of the point, in a notch.
    radius = ahead > 0.0 ? std::min(0.9 * radius, 0.5 * Dot(way, way) / ahead) : 0.5 * radius;
  }
  return touched.Point + radius * inward;
}
}

#endif
