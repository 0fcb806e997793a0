// SPDX-License-Identifier: BSD-3-Clause
#ifndef ShrinkBall_h
#define ShrinkBall_h

#include "packer/TriangleTree.h"

namespace spherepacking
{
/// The shrinking ball algorithm: the centre of a medial ball, the largest inside the surface that
/// touches it at the point nearest to `point`, but with a radius up to `maximumRadius`.
///
/// The ball shrinks until no part of the surface is in it, each time so that it also touches the
/// surface's nearest point to its centre.
/// Source: Ma, Bae and Choi, "3D medial axis point approximation using nearest neighbors and the
/// normal field" (2012).
inline Vector3 ShrinkBall(const TriangleTree& surface, const Vector3& point, double maximumRadius)
{
  constexpr int steps = 30;
  double distance = 1e300;
  TriangleTree::Nearest touched;
  surface.FindNearest(point, distance, touched);
  const Vector3 inward = -1.0 * surface.NormalOf(touched.Triangle);
  double radius = maximumRadius;
  for (int i = 0; i < steps; ++i)
  {
    const Vector3 center = touched.Point + radius * inward;
    distance = radius * (1.0 - 1e-6);
    TriangleTree::Nearest nearest;
    if (!surface.FindNearest(center, distance, nearest))
    {
      break;
    }
    const Vector3 chord = nearest.Point - touched.Point;
    const double ahead = Dot(chord, inward);
    // What is not ahead is a neighbour of the touched point, in a notch of the surface.
    radius = ahead > 0.0 ? std::min(0.9 * radius, 0.5 * Dot(chord, chord) / ahead) : 0.5 * radius;
  }
  return touched.Point + radius * inward;
}
}

#endif
