// SPDX-License-Identifier: BSD-3-Clause
#include "packer/OrientPatches.h"

#include <cmath>
#include <stdexcept>

namespace spherepacking
{
namespace
{
// A triangle across an edge that it shares with one other.
struct Neighbor
{
  std::int32_t Triangle;
  bool Consistent; // both run along the edge in opposite directions
};

using Adjacency = std::vector<std::vector<Neighbor>>;

Adjacency NeighborsOf(const SurfaceMesh& mesh, const EdgeTable& edges)
{
  Adjacency neighbors(mesh.Triangles.size());
  edges.ForEachEdge(
    [&](const HalfEdge* first, const HalfEdge* last)
    {
      if (last - first == 2)
      {
        const bool consistent = first[0].Forward != first[1].Forward;
        neighbors[first[0].Triangle].push_back({ first[1].Triangle, consistent });
        neighbors[first[1].Triangle].push_back({ first[0].Triangle, consistent });
      }
    });
  return neighbors;
}

double TwiceArea(const SurfaceMesh& mesh, const Triangle& triangle)
{
  return Length(Cross(mesh.Corner(triangle, 1) - mesh.Corner(triangle, 0),
    mesh.Corner(triangle, 2) - mesh.Corner(triangle, 0)));
}

// The patch that holds `seed`, breadth first. `sides` becomes 0 for those of its triangles that are
// consistent with the seed and 1 for the others; it is -1 where no patch has been.
TriangleIds GrowPatch(
  SurfaceMesh& mesh, const Adjacency& neighbors, std::int32_t seed, std::vector<int>& sides)
{
  TriangleIds patch{ seed };
  sides[seed] = 0;
  double areas[2] = {};
  for (std::size_t i = 0; i < patch.size(); ++i)
  {
    const std::int32_t at = patch[i];
    areas[sides[at]] += TwiceArea(mesh, mesh.Triangles[at]);
    for (const Neighbor& neighbor : neighbors[at])
    {
      const int side = neighbor.Consistent ? sides[at] : 1 - sides[at];
      if (sides[neighbor.Triangle] < 0)
      {
        sides[neighbor.Triangle] = side;
        patch.push_back(neighbor.Triangle);
      }
      else if (sides[neighbor.Triangle] != side)
      {
        throw std::invalid_argument("surface: found one that has no inside, since it has but one "
                                    "side, expected a closed surface");
      }
    }
  }
  const int smaller = areas[1] > areas[0] ? 0 : 1;
  for (const std::int32_t at : patch)
  {
    if (sides[at] == smaller)
    {
      Flip(mesh.Triangles[at]);
    }
  }
  return patch;
}

// How many triangles of a list a ray crosses.
int CountCrossings(const SurfaceMesh& mesh, const TriangleIds& triangles, std::int32_t except,
  const Vector3& origin, const Vector3& direction)
{
  int crossings = 0;
  for (const std::int32_t i : triangles)
  {
    if (i == except)
    {
      continue;
    }
    const Triangle& triangle = mesh.Triangles[i];
    const Vector3 a = mesh.Corner(triangle, 0) - origin;
    const Vector3 b = mesh.Corner(triangle, 1) - origin;
    const Vector3 c = mesh.Corner(triangle, 2) - origin;
    const double u = Dot(direction, Cross(a, b));
    const double v = Dot(direction, Cross(b, c));
    const double w = Dot(direction, Cross(c, a));
    const bool through = (u > 0.0) == (v > 0.0) && (v > 0.0) == (w > 0.0);
    // In front of the origin, the triple product has the sign of the others.
    crossings += through && (Dot(a, Cross(b, c)) > 0.0) == (u > 0.0) ? 1 : 0;
  }
  return crossings;
}
}

//------------------------------------------------------------------------------
std::vector<TriangleIds> OrientPatches(SurfaceMesh& mesh, const EdgeTable& edges)
{
  const Adjacency neighbors = NeighborsOf(mesh, edges);
  std::vector<TriangleIds> patches;
  std::vector<int> sides(mesh.Triangles.size(), -1);
  for (std::size_t seed = 0; seed < sides.size(); ++seed)
  {
    if (sides[seed] < 0)
    {
      patches.push_back(GrowPatch(mesh, neighbors, static_cast<std::int32_t>(seed), sides));
    }
  }
  return patches;
}

//------------------------------------------------------------------------------
void OrientByRays(SurfaceMesh& mesh, const TriangleIds& shell, const TriangleIds& patch)
{
  // Steps of the R2 sequence, for a point of a triangle, and of the R3 sequence, for a direction
  // about its normal. Both fill the unit square and cube evenly from the first numbers on.
  // Source: M. Roberts, "The unreasonable effectiveness of quasirandom sequences" (2018).
  constexpr double r2[] = { 0.754878, 0.569840 };
  constexpr double r3[] = { 0.819173, 0.671044, 0.549700 };
  constexpr std::size_t rays = 15;
  int votes = 0;
  for (std::size_t ray = 0; ray < rays; ++ray)
  {
    const std::int32_t at = patch[ray * patch.size() / rays];
    const Triangle& triangle = mesh.Triangles[at];
    const Vector3 a = mesh.Corner(triangle, 0);
    const Vector3 b = mesh.Corner(triangle, 1);
    const Vector3 c = mesh.Corner(triangle, 2);
    const auto quasirandom = [ray](double step)
    {
      const double number = 0.5 + step * static_cast<double>(ray);
      return number - std::floor(number);
    };
    const double u = 0.1 + 0.4 * quasirandom(r2[0]);
    const double v = 0.1 + 0.4 * quasirandom(r2[1]);
    const Vector3 normal = Cross(b - a, c - a);
    const Vector3 aside{ quasirandom(r3[0]) - 0.5, quasirandom(r3[1]) - 0.5,
      quasirandom(r3[2]) - 0.5 };
    const int crossings = CountCrossings(
      mesh, shell, at, a + u * (b - a) + v * (c - a), normal + (0.5 * Length(normal)) * aside);
    votes += crossings % 2 == 0 ? 1 : -1;
  }
  for (std::size_t i = 0; votes < 0 && i < patch.size(); ++i)
  {
    Flip(mesh.Triangles[patch[i]]);
  }
}
}
