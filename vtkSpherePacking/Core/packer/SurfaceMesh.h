// SPDX-License-Identifier: BSD-3-Clause
#ifndef SurfaceMesh_h
#define SurfaceMesh_h

#include "base/Vector3.h"

#include <array>
#include <cstdint>
#include <string>
#include <vector>

namespace spherepacking
{
using Triangle = std::array<std::int32_t, 3>;

/// Triangles that bound a solid.
struct SurfaceMesh
{
  std::vector<Vector3> Points;
  std::vector<Triangle> Triangles;

  Vector3 Corner(const Triangle& triangle, int i) const { return this->Points[triangle[i]]; }

  /// Of what is inside, where the triangles are turned outwards; what several shells share counts
  /// several times.
  double Volume() const;
};

/// The bounds of the points that triangles have.
struct MeshBox
{
  Vector3 Low;
  Vector3 High;

  Vector3 Middle() const { return 0.5 * (this->Low + this->High); }
  double LongestSide() const;
  bool Has(const MeshBox& other) const;
};

/// Of a mesh with triangles.
MeshBox BoxOf(const SurfaceMesh& mesh);

/// One side of a triangle, from the point of lower index to the other.
struct MeshEdge
{
  std::int32_t Low;
  std::int32_t High;
  std::int32_t Triangle;
  bool Forward; ///< whether the triangle's corners go that way
};

/// Sorted by their points.
std::vector<MeshEdge> EdgesOf(const SurfaceMesh& mesh);

/// Calls visit(first, last) for the edges between two points, for all such groups.
template <typename Visit>
inline void ForEachEdgeGroup(const std::vector<MeshEdge>& edges, Visit visit)
{
  std::size_t first = 0;
  while (first < edges.size())
  {
    std::size_t last = first + 1;
    while (last < edges.size() && edges[last].Low == edges[first].Low &&
      edges[last].High == edges[first].High)
    {
      ++last;
    }
    visit(edges.data() + first, edges.data() + last);
    first = last;
  }
}

/// Makes points at the same place one point, and drops triangles that have become lines. Of an odd
/// number of copies of a triangle one is left, turned as more of them are, of an even number two,
/// which may be a wall; but one where all have an even number.
void MergePoints(SurfaceMesh& mesh);

/// The same with other points, by their indices, in place of those there are.
void ReplacePoints(SurfaceMesh& mesh, const std::vector<std::int32_t>& others);

/// Takes triangles that are there twice out of a mesh that has others; returns one of each two.
std::vector<Triangle> TakeWalls(SurfaceMesh& mesh);

/// Leaves one of two copies where an edge has an odd number of triangles, and of copies beside
/// these.
void DropCopies(SurfaceMesh& mesh);

/// Where the surface is open, in words, or nothing if each edge has an even number of triangles.
std::string DescribeOpenEdges(const SurfaceMesh& mesh);
}

#endif
