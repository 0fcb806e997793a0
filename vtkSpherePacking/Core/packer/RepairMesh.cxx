// SPDX-License-Identifier: BSD-3-Clause
#include "packer/RepairMesh.h"

#include "packer/EdgeTable.h"

#include <algorithm>
#include <numeric>
#include <tuple>

namespace spherepacking
{
namespace
{
// Calls visit(first, last) with the ascending indices of each group of duplicates, which may be one
// triangle alone.
template <typename Visit>
void ForEachDuplicates(const std::vector<Triangle>& triangles, Visit visit)
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

void Remove(const std::vector<bool>& removed, std::vector<Triangle>& triangles)
{
  std::vector<Triangle> others;
  for (std::size_t i = 0; i < triangles.size(); ++i)
  {
    if (!removed[i])
    {
      others.push_back(triangles[i]);
    }
  }
  triangles = std::move(others);
}

// Whether the corners are an even permutation of their ascending order: tells apart the two
// orientations of duplicates.
bool IsEven(const Triangle& t)
{
  return ((t[0] < t[1] ? 1 : 0) + (t[1] < t[2] ? 1 : 0) + (t[2] < t[0] ? 1 : 0)) == 2;
}

// See MergePoints(). That every triangle has an even number of duplicates is how files look that
// hold both sides of each facet.
void ReduceDuplicates(std::vector<Triangle>& triangles)
{
  bool allPaired = true;
  ForEachDuplicates(triangles, [&](const std::int32_t* first, const std::int32_t* last)
    { allPaired = allPaired && (last - first) % 2 == 0; });
  std::vector<bool> removed(triangles.size(), false);
  ForEachDuplicates(triangles,
    [&](const std::int32_t* first, const std::int32_t* last)
    {
      // Those that stay all have the orientation of the majority; one of each if there is none.
      const std::ptrdiff_t stay = (last - first) % 2 == 0 && !allPaired ? 2 : 1;
      const std::ptrdiff_t even =
        std::count_if(first, last, [&](std::int32_t at) { return IsEven(triangles[at]); });
      const std::ptrdiff_t net = 2 * even - (last - first);
      const bool evenFirst = net > 0 || (net == 0 && IsEven(triangles[*first]));
      std::ptrdiff_t remaining[2]; // to stay, of each orientation
      remaining[evenFirst ? 1 : 0] = net == 0 ? (stay + 1) / 2 : stay;
      remaining[evenFirst ? 0 : 1] = net == 0 ? stay / 2 : 0;
      for (const std::int32_t* at = first; at < last; ++at)
      {
        removed[*at] = remaining[IsEven(triangles[*at]) ? 1 : 0]-- <= 0;
      }
    });
  Remove(removed, triangles);
}
}

//------------------------------------------------------------------------------
void MergeCoincidentPoints(SurfaceMesh& mesh)
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
  MergePoints(mesh, first);
}

//------------------------------------------------------------------------------
void MergePoints(SurfaceMesh& mesh, const std::vector<std::int32_t>& others)
{
  std::vector<Triangle> triangles;
  triangles.reserve(mesh.Triangles.size());
  for (const Triangle& triangle : mesh.Triangles)
  {
    const Triangle merged = { others[triangle[0]], others[triangle[1]], others[triangle[2]] };
    if (merged[0] != merged[1] && merged[1] != merged[2] && merged[2] != merged[0])
    {
      triangles.push_back(merged);
    }
  }
  mesh.Triangles = std::move(triangles);
  ReduceDuplicates(mesh.Triangles);
}

//------------------------------------------------------------------------------
std::vector<Triangle> TakeDoubleSided(SurfaceMesh& mesh)
{
  std::vector<Triangle> facets;
  std::vector<bool> taken(mesh.Triangles.size(), false);
  ForEachDuplicates(mesh.Triangles,
    [&](const std::int32_t* first, const std::int32_t* last)
    {
      if (last - first == 2)
      {
        facets.push_back(mesh.Triangles[*first]);
        taken[first[0]] = taken[first[1]] = true;
      }
    });
  if (facets.size() * 2 == mesh.Triangles.size())
  {
    return {};
  }
  Remove(taken, mesh.Triangles);
  return facets;
}

//------------------------------------------------------------------------------
void DropDuplicates(SurfaceMesh& mesh)
{
  // The second triangle of the double-sided facet that a triangle belongs to, or -1.
  std::vector<std::int32_t> second(mesh.Triangles.size(), -1);
  ForEachDuplicates(mesh.Triangles,
    [&](const std::int32_t* first, const std::int32_t* last)
    {
      for (const std::int32_t* at = first; last - first == 2 && at < last; ++at)
      {
        second[*at] = first[1];
      }
    });
  const EdgeTable edges(mesh);
  std::vector<bool> dropped(mesh.Triangles.size(), false);
  for (bool more = true; more;)
  {
    more = false;
    edges.ForEachEdge(
      [&](const HalfEdge* first, const HalfEdge* last)
      {
        bool drops = (last - first) % 2 != 0;
        for (const HalfEdge* at = first; at != last; ++at)
        {
          const std::int32_t duplicate = second[at->Triangle];
          drops = drops || (duplicate >= 0 && dropped[duplicate]);
        }
        for (const HalfEdge* at = first; drops && at != last; ++at)
        {
          const std::int32_t duplicate = second[at->Triangle];
          if (duplicate >= 0 && !dropped[duplicate])
          {
            dropped[duplicate] = true;
            more = true;
          }
        }
      });
  }
  Remove(dropped, mesh.Triangles);
}
}
