// SPDX-License-Identifier: BSD-3-Clause
#ifndef EdgeTable_h
#define EdgeTable_h

#include "packer/SurfaceMesh.h"

#include <cstddef>
#include <string>

namespace spherepacking
{
/// A triangle's side of an edge, directed as the triangle's corners run.
struct HalfEdge
{
  std::int32_t Low; ///< the end of lower index
  std::int32_t High;
  std::int32_t Triangle;
  bool Forward; ///< from Low to High
};

/// The half-edges from `first` up to `last` that run forward less those that run backward.
int NetDirection(const HalfEdge* first, const HalfEdge* last);

/// The half-edges of a mesh, sorted by edge and then by triangle.
///
/// Any number of triangles may share an edge, whichever way they are oriented, whereas half-edge
/// data structures, made for walking from face to face, take two at most. An edge is open if an odd
/// number of triangles share it. It is unbalanced if they do not run along it as often forward as
/// backward: there the oriented triangles, as a chain, have a boundary.
class EdgeTable
{
public:
  explicit EdgeTable(const SurfaceMesh& mesh);

  /// Calls visit(first, last) with the half-edges of each edge.
  template <typename Visit>
  void ForEachEdge(Visit visit) const;

  /// Calls visit(halfEdge) for those whose edge is unbalanced among the triangles of the same
  /// group; `groups` has a number for each triangle.
  template <typename Visit>
  void ForEachUnbalanced(const std::vector<std::int32_t>& groups, Visit visit) const;

private:
  std::vector<HalfEdge> HalfEdges;
};

/// Says how many edges of a mesh are open and where the first of them is, or nothing if none is.
std::string DescribeOpenEdges(const SurfaceMesh& mesh);

//------------------------------------------------------------------------------
template <typename Visit>
void EdgeTable::ForEachEdge(Visit visit) const
{
  const std::vector<HalfEdge>& all = this->HalfEdges;
  std::size_t first = 0;
  while (first < all.size())
  {
    std::size_t last = first + 1;
    while (
      last < all.size() && all[last].Low == all[first].Low && all[last].High == all[first].High)
    {
      ++last;
    }
    visit(all.data() + first, all.data() + last);
    first = last;
  }
}

//------------------------------------------------------------------------------
template <typename Visit>
void EdgeTable::ForEachUnbalanced(const std::vector<std::int32_t>& groups, Visit visit) const
{
  this->ForEachEdge(
    [&](const HalfEdge* first, const HalfEdge* last)
    {
      for (const HalfEdge* one = first; one != last; ++one)
      {
        std::int64_t sum = 0;
        for (const HalfEdge* other = first; other != last; ++other)
        {
          const bool same = groups[other->Triangle] == groups[one->Triangle];
          sum += same ? (other->Forward ? 1 : -1) : 0;
        }
        if (sum != 0)
        {
          visit(*one);
        }
      }
    });
}
}

#endif
