// SPDX-License-Identifier: BSD-3-Clause
#include "packer/SurfaceMesh.h"

#include <algorithm>
#include <numeric>
#include <sstream>
#include <tuple>

namespace spherepacking
{
namespace
{
void Write(std::ostream& os, const Vector3& point)
{
  os << "(" << point.X << ", " << point.Y << ", " << point.Z << ")";
}

// Calls visit(first, last) for the indices, in rising order, of triangles with the same points.
template <typename Visit>
void ForEachCopies(const std::vector<Triangle>& triangles, Visit visit)
{
  const auto key = [](Triangle triangle)
  {
    std::sort(triangle.begin(), triangle.end());
    return triangle;
  };
  std::vector<std::int32_t> order(triangles.size());
  std::iota(order.begin(), order.end(), 0);
  std::sort(order.begin(), order.end(),
    [&](std::int32_t a, std::int32_t b)
    {
      const Triangle one = key(triangles[a]);
      const Triangle other = key(triangles[b]);
      return one != other ? one < other : a < b;
    });
  for (std::size_t first = 0; first < order.size();)
  {
    std::size_t last = first;
    while (last < order.size() && key(triangles[order[last]]) == key(triangles[order[first]]))
    {
      ++last;
    }
    visit(order.data() + first, order.data() + last);
    first = last;
  }
}

void Drop(const std::vector<bool>& dropped, std::vector<Triangle>& triangles)
{
  std::vector<Triangle> kept;
  for (std::size_t i = 0; i < triangles.size(); ++i)
  {
    if (!dropped[i])
    {
      kept.push_back(triangles[i]);
    }
  }
  triangles = std::move(kept);
}

// Whether the corners rise in an even permutation of their order.
bool IsForward(const Triangle& t)
{
  return ((t[0] < t[1] ? 1 : 0) + (t[1] < t[2] ? 1 : 0) + (t[2] < t[0] ? 1 : 0)) == 2;
}

// Leaves one of an odd number of copies, and two of an even one, which may be a wall within a
// solid; but one where all have an even number, as where both sides of all are drawn.
void ReduceCopies(std::vector<Triangle>& triangles)
{
  bool even = true;
  ForEachCopies(triangles, [&](const std::int32_t* first, const std::int32_t* last)
    { even = even && (last - first) % 2 == 0; });
  std::vector<bool> dropped(triangles.size(), false);
  ForEachCopies(triangles,
    [&](const std::int32_t* first, const std::int32_t* last)
    {
      // As often one way more than the other as they all are, if that is possible.
      const std::ptrdiff_t kept = (last - first) % 2 == 0 && !even ? 2 : 1;
      const std::ptrdiff_t forward =
        std::count_if(first, last, [&](std::int32_t at) { return IsForward(triangles[at]); });
      const std::ptrdiff_t net = 2 * forward - (last - first);
      const bool forwardFirst = net > 0 || (net == 0 && IsForward(triangles[*first]));
      std::ptrdiff_t left[2]; // of each direction
      left[forwardFirst ? 1 : 0] = net == 0 ? (kept + 1) / 2 : kept;
      left[forwardFirst ? 0 : 1] = net == 0 ? kept / 2 : 0;
      for (const std::int32_t* at = first; at < last; ++at)
      {
        dropped[*at] = left[IsForward(triangles[*at]) ? 1 : 0]-- <= 0;
      }
    });
  Drop(dropped, triangles);
}
}

//------------------------------------------------------------------------------
double SurfaceMesh::Volume() const
{
  if (this->Points.empty())
  {
    return 0.0;
  }
  // From one of the points: far from the origin, differences of large products would lose digits.
  const Vector3 origin = this->Points.front();
  double sum = 0.0;
  for (const Triangle& triangle : this->Triangles)
  {
    sum += Dot(this->Corner(triangle, 0) - origin,
      Cross(this->Corner(triangle, 1) - origin, this->Corner(triangle, 2) - origin));
  }
  return sum / 6.0;
}

//------------------------------------------------------------------------------
double MeshBox::LongestSide() const
{
  const Vector3 size = this->High - this->Low;
  return std::max(std::max(size.X, size.Y), size.Z);
}

//------------------------------------------------------------------------------
bool MeshBox::Has(const MeshBox& other) const
{
  for (int axis = 0; axis < 3; ++axis)
  {
    if (other.Low[axis] < this->Low[axis] || other.High[axis] > this->High[axis])
    {
      return false;
    }
  }
  return true;
}

//------------------------------------------------------------------------------
MeshBox BoxOf(const SurfaceMesh& mesh)
{
  const Vector3 first = mesh.Corner(mesh.Triangles.front(), 0);
  MeshBox box{ first, first };
  for (const Triangle& triangle : mesh.Triangles)
  {
    for (int corner = 0; corner < 3; ++corner)
    {
      const Vector3 point = mesh.Corner(triangle, corner);
      for (int axis = 0; axis < 3; ++axis)
      {
        box.Low[axis] = std::min(box.Low[axis], point[axis]);
        box.High[axis] = std::max(box.High[axis], point[axis]);
      }
    }
  }
  return box;
}

//------------------------------------------------------------------------------
std::vector<MeshEdge> EdgesOf(const SurfaceMesh& mesh)
{
  std::vector<MeshEdge> edges;
  edges.reserve(3 * mesh.Triangles.size());
  for (std::size_t i = 0; i < mesh.Triangles.size(); ++i)
  {
    for (int side = 0; side < 3; ++side)
    {
      const std::int32_t from = mesh.Triangles[i][side];
      const std::int32_t to = mesh.Triangles[i][(side + 1) % 3];
      edges.push_back(
        { std::min(from, to), std::max(from, to), static_cast<std::int32_t>(i), from < to });
    }
  }
  std::sort(edges.begin(), edges.end(), [](const MeshEdge& a, const MeshEdge& b)
    { return std::tie(a.Low, a.High, a.Triangle) < std::tie(b.Low, b.High, b.Triangle); });
  return edges;
}

//------------------------------------------------------------------------------
void MergePoints(SurfaceMesh& mesh)
{
  const auto key = [&](std::int32_t i)
  {
    const Vector3& point = mesh.Points[i];
    return std::tie(point.X, point.Y, point.Z);
  };
  std::vector<std::int32_t> order(mesh.Points.size());
  std::iota(order.begin(), order.end(), 0);
  std::sort(order.begin(), order.end(),
    [&](std::int32_t a, std::int32_t b) { return key(a) != key(b) ? key(a) < key(b) : a < b; });
  std::vector<std::int32_t> first(mesh.Points.size());
  for (std::size_t i = 0; i < order.size(); ++i)
  {
    first[order[i]] = i > 0 && key(order[i - 1]) == key(order[i]) ? first[order[i - 1]] : order[i];
  }
  ReplacePoints(mesh, first);
}

//------------------------------------------------------------------------------
void ReplacePoints(SurfaceMesh& mesh, const std::vector<std::int32_t>& first)
{
  std::vector<Triangle> triangles;
  triangles.reserve(mesh.Triangles.size());
  for (const Triangle& triangle : mesh.Triangles)
  {
    const Triangle merged = { first[triangle[0]], first[triangle[1]], first[triangle[2]] };
    if (merged[0] != merged[1] && merged[1] != merged[2] && merged[2] != merged[0])
    {
      triangles.push_back(merged);
    }
  }
  mesh.Triangles = std::move(triangles);
  ReduceCopies(mesh.Triangles);
}

//------------------------------------------------------------------------------
std::vector<Triangle> TakeWalls(SurfaceMesh& mesh)
{
  std::vector<Triangle> walls;
  std::vector<bool> taken(mesh.Triangles.size(), false);
  ForEachCopies(mesh.Triangles,
    [&](const std::int32_t* first, const std::int32_t* last)
    {
      if (last - first == 2)
      {
        walls.push_back(mesh.Triangles[*first]);
        taken[first[0]] = taken[first[1]] = true;
      }
    });
  if (walls.size() * 2 == mesh.Triangles.size())
  {
    return {};
  }
  Drop(taken, mesh.Triangles);
  return walls;
}

//------------------------------------------------------------------------------
void DropCopies(SurfaceMesh& mesh)
{
  std::vector<std::int32_t> second(mesh.Triangles.size(), -1); // of both, the second
  ForEachCopies(mesh.Triangles,
    [&](const std::int32_t* first, const std::int32_t* last)
    {
      for (const std::int32_t* at = first; last - first == 2 && at < last; ++at)
      {
        second[*at] = first[1];
      }
    });
  // From odd edges on, to those with which they share an edge.
  const std::vector<MeshEdge> edges = EdgesOf(mesh);
  std::vector<bool> dropped(mesh.Triangles.size(), false);
  for (bool more = true; more;)
  {
    more = false;
    ForEachEdgeGroup(edges,
      [&](const MeshEdge* first, const MeshEdge* last)
      {
        bool drops = (last - first) % 2 != 0;
        for (const MeshEdge* edge = first; edge != last; ++edge)
        {
          const std::int32_t copy = second[edge->Triangle];
          drops = drops || (copy >= 0 && dropped[copy]);
        }
        for (const MeshEdge* edge = first; drops && edge != last; ++edge)
        {
          const std::int32_t copy = second[edge->Triangle];
          if (copy >= 0 && !dropped[copy])
          {
            dropped[copy] = true;
            more = true;
          }
        }
      });
  }
  Drop(dropped, mesh.Triangles);
}

//------------------------------------------------------------------------------
std::string DescribeOpenEdges(const SurfaceMesh& mesh)
{
  std::int64_t open = 0;
  Vector3 ends[2];
  ForEachEdgeGroup(EdgesOf(mesh),
    [&](const MeshEdge* first, const MeshEdge* last)
    {
      if ((last - first) % 2 != 0 && open++ == 0)
      {
        ends[0] = mesh.Points[first->Low];
        ends[1] = mesh.Points[first->High];
      }
    });
  if (open == 0)
  {
    return {};
  }
  std::ostringstream text;
  text.precision(9);
  text << open << " open edge" << (open > 1 ? "s, the first" : "") << " from ";
  Write(text, ends[0]);
  text << " to ";
  Write(text, ends[1]);
  return text.str();
}
}
