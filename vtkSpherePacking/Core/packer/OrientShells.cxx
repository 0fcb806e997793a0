// SPDX-License-Identifier: BSD-3-Clause
#include "packer/OrientShells.h"

#include "packer/TriangleTree.h"

#include <algorithm>
#include <cmath>
#include <memory>
#include <numeric>
#include <stdexcept>

namespace spherepacking
{
namespace
{
using Ids = std::vector<std::int32_t>;

void Turn(Triangle& triangle)
{
  std::swap(triangle[1], triangle[2]);
}

// Sets of numbers that grow together.
class Union
{
public:
  explicit Union(std::size_t count)
    : Parents(count)
  {
    std::iota(this->Parents.begin(), this->Parents.end(), 0);
  }
  std::int32_t Find(std::int32_t i)
  {
    while (this->Parents[i] != i)
    {
      this->Parents[i] = this->Parents[this->Parents[i]];
      i = this->Parents[i];
    }
    return i;
  }
  void Join(std::int32_t a, std::int32_t b) { this->Parents[this->Find(a)] = this->Find(b); }

  // The members of each set, both in rising order.
  std::vector<Ids> Sets()
  {
    std::vector<Ids> sets;
    Ids number(this->Parents.size(), -1);
    for (std::size_t i = 0; i < this->Parents.size(); ++i)
    {
      std::int32_t& at = number[this->Find(static_cast<std::int32_t>(i))];
      if (at < 0)
      {
        at = static_cast<std::int32_t>(sets.size());
        sets.emplace_back();
      }
      sets[at].push_back(static_cast<std::int32_t>(i));
    }
    return sets;
  }

private:
  Ids Parents;
};

SurfaceMesh Part(const SurfaceMesh& mesh, const Ids& triangles)
{
  SurfaceMesh part;
  for (const std::int32_t i : triangles)
  {
    Triangle triangle;
    for (int corner = 0; corner < 3; ++corner)
    {
      triangle[corner] = static_cast<std::int32_t>(part.Points.size());
      part.Points.push_back(mesh.Corner(mesh.Triangles[i], corner));
    }
    part.Triangles.push_back(triangle);
  }
  return part;
}

// Turns the triangles of each patch alike: the fewer, by area, as the others are.
std::vector<Ids> OrientPatches(SurfaceMesh& mesh, const std::vector<MeshEdge>& edges)
{
  struct Link
  {
    std::int32_t Other;
    bool Same; // both are turned the same way
  };
  std::vector<std::vector<Link>> links(mesh.Triangles.size());
  ForEachEdgeGroup(edges,
    [&](const MeshEdge* first, const MeshEdge* last)
    {
      if (last - first == 2)
      {
        const bool same = first[0].Forward != first[1].Forward;
        links[first[0].Triangle].push_back({ first[1].Triangle, same });
        links[first[1].Triangle].push_back({ first[0].Triangle, same });
      }
    });
  std::vector<Ids> patches;
  std::vector<int> turned(mesh.Triangles.size(), -1);
  for (std::size_t seed = 0; seed < turned.size(); ++seed)
  {
    if (turned[seed] >= 0)
    {
      continue;
    }
    Ids patch{ static_cast<std::int32_t>(seed) };
    turned[seed] = 0;
    double areas[2] = {};
    for (std::size_t i = 0; i < patch.size(); ++i)
    {
      const std::int32_t at = patch[i];
      const Triangle& triangle = mesh.Triangles[at];
      areas[turned[at]] += Length(Cross(mesh.Corner(triangle, 1) - mesh.Corner(triangle, 0),
        mesh.Corner(triangle, 2) - mesh.Corner(triangle, 0)));
      for (const Link& link : links[at])
      {
        const int wanted = link.Same ? turned[at] : 1 - turned[at];
        if (turned[link.Other] < 0)
        {
          turned[link.Other] = wanted;
          patch.push_back(link.Other);
        }
        else if (turned[link.Other] != wanted)
        {
          throw std::invalid_argument("surface: found one that has no inside, since it has but one "
                                      "side, expected a closed surface");
        }
      }
    }
    const int fewer = areas[1] > areas[0] ? 0 : 1;
    for (const std::int32_t at : patch)
    {
      if (turned[at] == fewer)
      {
        Turn(mesh.Triangles[at]);
      }
    }
    patches.push_back(std::move(patch));
  }
  return patches;
}

// Calls visit(edge) for the edges where the triangles of a group, by their numbers in `groups`, do
// not go as often one way as the other.
template <typename Visit>
void ForEachUnbalanced(const std::vector<MeshEdge>& edges, const Ids& groups, Visit visit)
{
  ForEachEdgeGroup(edges,
    [&](const MeshEdge* first, const MeshEdge* last)
    {
      for (const MeshEdge* edge = first; edge != last; ++edge)
      {
        std::int64_t sum = 0;
        for (const MeshEdge* other = first; other != last; ++other)
        {
          const bool same = groups[other->Triangle] == groups[edge->Triangle];
          sum += same ? (other->Forward ? 1 : -1) : 0;
        }
        if (sum != 0)
        {
          visit(*edge);
        }
      }
    });
}

// How many triangles a line from a place meets.
int Crossings(const SurfaceMesh& mesh, const Ids& triangles, std::int32_t without,
  const Vector3& place, const Vector3& direction)
{
  int crossings = 0;
  for (const std::int32_t i : triangles)
  {
    if (i == without)
    {
      continue;
    }
    const Triangle& triangle = mesh.Triangles[i];
    const Vector3 a = mesh.Corner(triangle, 0) - place;
    const Vector3 b = mesh.Corner(triangle, 1) - place;
    const Vector3 c = mesh.Corner(triangle, 2) - place;
    const double u = Dot(direction, Cross(a, b));
    const double v = Dot(direction, Cross(b, c));
    const double w = Dot(direction, Cross(c, a));
    const bool through = (u > 0.0) == (v > 0.0) && (v > 0.0) == (w > 0.0);
    // In front: the triple product has the sign of the others.
    crossings += through && (Dot(a, Cross(b, c)) > 0.0) == (u > 0.0) ? 1 : 0;
  }
  return crossings;
}

// Patches meet where more than two triangles do. From a triangle outwards, an even number of others
// lies ahead; lines from places all over the patch vote, since one may meet an edge.
void OrientByCrossings(SurfaceMesh& mesh, const Ids& shell, const Ids& patch)
{
  constexpr std::size_t voters = 15;
  int votes = 0;
  for (std::size_t vote = 0; vote < voters; ++vote)
  {
    const std::int32_t at = patch[vote * patch.size() / voters];
    const Triangle& triangle = mesh.Triangles[at];
    const Vector3 a = mesh.Corner(triangle, 0);
    const Vector3 b = mesh.Corner(triangle, 1);
    const Vector3 c = mesh.Corner(triangle, 2);
    // Numbers that spread evenly, for a place and a direction.
    const auto spread = [vote](double step)
    {
      const double number = 0.5 + step * static_cast<double>(vote);
      return number - std::floor(number);
    };
    const double u = 0.1 + 0.4 * spread(0.754878);
    const double v = 0.1 + 0.4 * spread(0.569840);
    const Vector3 normal = Cross(b - a, c - a);
    const Vector3 aside{ spread(0.819173) - 0.5, spread(0.671044) - 0.5, spread(0.549700) - 0.5 };
    const int crossings = Crossings(
      mesh, shell, at, a + u * (b - a) + v * (c - a), normal + (0.5 * Length(normal)) * aside);
    votes += crossings % 2 == 0 ? 1 : -1;
  }
  for (std::size_t i = 0; votes < 0 && i < patch.size(); ++i)
  {
    Turn(mesh.Triangles[patch[i]]);
  }
}

// Of each triangle, its patch if that is closed by itself, or -1.
Ids ClosedPatches(const std::vector<MeshEdge>& edges, const std::vector<Ids>& patches)
{
  Ids patchOf(edges.size() / 3);
  for (std::size_t i = 0; i < patches.size(); ++i)
  {
    for (const std::int32_t at : patches[i])
    {
      patchOf[at] = static_cast<std::int32_t>(i);
    }
  }
  std::vector<bool> closed(patches.size(), true);
  ForEachUnbalanced(
    edges, patchOf, [&](const MeshEdge& edge) { closed[patchOf[edge.Triangle]] = false; });
  for (std::int32_t& patch : patchOf)
  {
    patch = closed[patch] ? patch : -1;
  }
  return patchOf;
}

// Shells as lists of triangles, each turned so that its volume is above 0; none if that is stopped.
std::vector<Ids> OrientEachShell(
  SurfaceMesh& mesh, std::vector<MeshEdge>&& edges, const std::function<bool()>& goOn)
{
  // Patches that are turned the wrong way may fit each other, so nothing can be told from them
  // later.
  Ids turned;
  ForEachUnbalanced(edges, Ids(mesh.Triangles.size(), 0),
    [&](const MeshEdge& edge) { turned.push_back(edge.Triangle); });
  const std::vector<Ids> patches = OrientPatches(mesh, edges);
  edges = EdgesOf(mesh);
  Union joined(mesh.Triangles.size());
  const Ids closed = ClosedPatches(edges, patches);
  ForEachEdgeGroup(edges,
    [&](const MeshEdge* first, const MeshEdge* last)
    {
      // Solids that only touch along an edge are shells of their own.
      for (const MeshEdge* edge = first; edge != last; ++edge)
      {
        for (const MeshEdge* other = first; other != edge; ++other)
        {
          if (closed[edge->Triangle] == closed[other->Triangle])
          {
            joined.Join(other->Triangle, edge->Triangle);
          }
        }
      }
    });
  const std::vector<Ids> shells = joined.Sets();
  Ids shellOf(mesh.Triangles.size());
  for (std::size_t i = 0; i < shells.size(); ++i)
  {
    for (const std::int32_t at : shells[i])
    {
      shellOf[at] = static_cast<std::int32_t>(i);
    }
  }
  std::vector<bool> isUnbalanced(shells.size(), false);
  for (const std::int32_t at : turned)
  {
    isUnbalanced[shellOf[at]] = true;
  }
  ForEachUnbalanced(
    edges, shellOf, [&](const MeshEdge& edge) { isUnbalanced[shellOf[edge.Triangle]] = true; });
  for (const Ids& patch : patches)
  {
    if (!goOn())
    {
      return {};
    }
    const std::int32_t shell = shellOf[patch.front()];
    if (isUnbalanced[shell] && patch.size() < shells[shell].size())
    {
      OrientByCrossings(mesh, shells[shell], patch);
    }
  }
  for (const Ids& shell : shells)
  {
    if (Part(mesh, shell).Volume() < 0.0)
    {
      for (const std::int32_t at : shell)
      {
        Turn(mesh.Triangles[at]);
      }
    }
  }
  return shells;
}

// Whether all of it does that is not a wall of both.
bool LiesWithin(const SurfaceMesh& mesh, const Ids& shell, const TriangleTree& other)
{
  constexpr std::size_t samples = 1000;
  constexpr double wall = 1e-6; // a surface is about 1 long
  const std::size_t step = std::max<std::size_t>(1, shell.size() / samples);
  bool any = false;
  for (std::size_t i = 0; i < shell.size(); i += step)
  {
    const Triangle& triangle = mesh.Triangles[shell[i]];
    const Vector3 middle = (1.0 / 3.0) *
      (mesh.Corner(triangle, 0) + mesh.Corner(triangle, 1) + mesh.Corner(triangle, 2));
    // Not far from the corners, which show earlier what pokes out.
    for (int corner = 0; corner < 3; ++corner)
    {
      const Vector3 place = middle + 0.9 * (mesh.Corner(triangle, corner) - middle);
      double distance = wall;
      TriangleTree::Nearest nearest;
      if (other.Closest(place, distance, nearest))
      {
        continue;
      }
      if (!(other.WindingNumber(place) > 0.5))
      {
        return false;
      }
      any = true;
    }
  }
  return any;
}

// Of surfaces without walls.
bool OrientSingle(
  SurfaceMesh& mesh, std::vector<MeshEdge>&& edges, const std::function<bool()>& goOn)
{
  const std::vector<Ids> shells = OrientEachShell(mesh, std::move(edges), goOn);
  std::vector<MeshBox> boxes;
  for (const Ids& shell : shells)
  {
    boxes.push_back(BoxOf(Part(mesh, shell)));
  }
  std::vector<int> depths(shells.size(), 0);
  for (std::size_t outer = 0; outer < shells.size(); ++outer)
  {
    if (!goOn())
    {
      return false;
    }
    std::unique_ptr<TriangleTree> tree;
    for (std::size_t inner = 0; inner < shells.size(); ++inner)
    {
      if (inner == outer || !boxes[outer].Has(boxes[inner]))
      {
        continue;
      }
      if (!tree)
      {
        tree.reset(new TriangleTree(Part(mesh, shells[outer])));
      }
      depths[inner] += LiesWithin(mesh, shells[inner], *tree) ? 1 : 0;
    }
  }
  for (std::size_t i = 0; i < shells.size(); ++i)
  {
    for (std::size_t at = 0; depths[i] % 2 != 0 && at < shells[i].size(); ++at)
    {
      Turn(mesh.Triangles[shells[i][at]]);
    }
  }
  return !shells.empty();
}
}

//------------------------------------------------------------------------------
bool OrientShells(SurfaceMesh& mesh, const std::function<bool()>& goOn)
{
  // Which way a triangle is turned that is there twice cannot be told from what is before it. Both
  // together bound nothing.
  std::vector<MeshEdge> edges = EdgesOf(mesh);
  bool isBalanced = true;
  ForEachUnbalanced(
    edges, Ids(mesh.Triangles.size(), 0), [&](const MeshEdge&) { isBalanced = false; });
  std::vector<Triangle> walls;
  if (!isBalanced)
  {
    walls = TakeWalls(mesh);
    edges = EdgesOf(mesh);
  }
  const bool done = OrientSingle(mesh, std::move(edges), goOn);
  for (Triangle wall : walls)
  {
    mesh.Triangles.push_back(wall);
    Turn(wall);
    mesh.Triangles.push_back(wall);
  }
  return done;
}
}
