// SPDX-License-Identifier: BSD-3-Clause
#ifndef SurfaceMesh_h
#define SurfaceMesh_h

#include "base/Vector3.h"

#include <array>
#include <cstdint>
#include <utility>
#include <vector>

namespace spherepacking
{
/// Three points, by their indices.
using Triangle = std::array<std::int32_t, 3>;

/// Reverses the orientation.
inline void Flip(Triangle& triangle)
{
  std::swap(triangle[1], triangle[2]);
}

/// Triangles that bound a solid.
struct SurfaceMesh
{
  std::vector<Vector3> Points;
  std::vector<Triangle> Triangles;

  Vector3 Corner(const Triangle& triangle, int i) const { return this->Points[triangle[i]]; }

  /// The volume inside triangles that are oriented outwards, by the divergence theorem; where
  /// shells overlap it counts once for each of them.
  double Volume() const;
};

/// An axis-aligned bounding box.
struct MeshBounds
{
  Vector3 Low;
  Vector3 High;

  Vector3 Center() const { return 0.5 * (this->Low + this->High); }
  double LongestSide() const;
  bool Contains(const MeshBounds& other) const;
};

/// The bounds of the triangles, of which there must be one; other points do not count.
MeshBounds BoundsOf(const SurfaceMesh& mesh);
}

#endif
