// SPDX-License-Identifier: BSD-3-Clause
#include "packer/OrientShells.h"

#include "base/DisjointSets.h"
#include "packer/OrientPatches.h"
#include "packer/RepairMesh.h"
#include "packer/TriangleTree.h"

#include <algorithm>
#include <memory>

namespace spherepacking
{
namespace
{
SurfaceMesh Submesh(const SurfaceMesh& mesh, const TriangleIds& triangles)
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

// The group of each triangle.
std::vector<std::int32_t> GroupsOf(const std::vector<TriangleIds>& groups, std::size_t triangles)
{
  std::vector<std::int32_t> groupOf(triangles);
  for (std::size_t i = 0; i < groups.size(); ++i)
  {
    for (const std::int32_t at : groups[i])
    {
      groupOf[at] = static_cast<std::int32_t>(i);
    }
  }
  return groupOf;
}

// The patch of each triangle if that is closed by itself, or -1.
std::vector<std::int32_t> ClosedPatches(
  const EdgeTable& edges, const std::vector<TriangleIds>& patches, std::size_t triangles)
{
  std::vector<std::int32_t> patchOf = GroupsOf(patches, triangles);
  std::vector<bool> closed(patches.size(), true);
  edges.ForEachUnbalanced(
    patchOf, [&](const HalfEdge& halfEdge) { closed[patchOf[halfEdge.Triangle]] = false; });
  for (std::int32_t& patch : patchOf)
  {
    patch = closed[patch] ? patch : -1;
  }
  return patchOf;
}

// Solids that only touch along an edge are shells of their own: their patches are closed.
std::vector<TriangleIds> FindShells(
  const EdgeTable& edges, const std::vector<TriangleIds>& patches, std::size_t triangles)
{
  DisjointSets shells(triangles);
  const std::vector<std::int32_t> closed = ClosedPatches(edges, patches, triangles);
  edges.ForEachEdge(
    [&](const HalfEdge* first, const HalfEdge* last)
    {
      for (const HalfEdge* one = first; one != last; ++one)
      {
        for (const HalfEdge* other = first; other != one; ++other)
        {
          if (closed[one->Triangle] == closed[other->Triangle])
          {
            shells.Unite(other->Triangle, one->Triangle);
          }
        }
      }
    });
  return shells.Sets();
}

// Returns the shells, each oriented so that its volume is above 0; none once `goOn` says no.
std::vector<TriangleIds> OrientEachShell(
  SurfaceMesh& mesh, EdgeTable&& edges, const std::function<bool()>& goOn)
{
  const std::size_t triangles = mesh.Triangles.size();
  // Found before patches are oriented: after that, edges may be balanced between patches that are
  // both oriented the wrong way.
  TriangleIds unbalanced;
  edges.ForEachUnbalanced(std::vector<std::int32_t>(triangles, 0),
    [&](const HalfEdge& halfEdge) { unbalanced.push_back(halfEdge.Triangle); });
  const std::vector<TriangleIds> patches = OrientPatches(mesh, edges);
  edges = EdgeTable(mesh);
  const std::vector<TriangleIds> shells = FindShells(edges, patches, triangles);
  const std::vector<std::int32_t> shellOf = GroupsOf(shells, triangles);
  std::vector<bool> isUnbalanced(shells.size(), false);
  for (const std::int32_t at : unbalanced)
  {
    isUnbalanced[shellOf[at]] = true;
  }
  edges.ForEachUnbalanced(
    shellOf, [&](const HalfEdge& halfEdge) { isUnbalanced[shellOf[halfEdge.Triangle]] = true; });
  for (const TriangleIds& patch : patches)
  {
    if (!goOn())
    {
      return {};
    }
    const std::int32_t shell = shellOf[patch.front()];
    if (isUnbalanced[shell] && patch.size() < shells[shell].size())
    {
      OrientByRays(mesh, shells[shell], patch);
    }
  }
  for (const TriangleIds& shell : shells)
  {
    if (Submesh(mesh, shell).Volume() < 0.0)
    {
      for (const std::int32_t at : shell)
      {
        Flip(mesh.Triangles[at]);
      }
    }
  }
  return shells;
}

// Whether sample points of the shell lie inside another, all but those where the two touch.
bool LiesWithin(const SurfaceMesh& mesh, const TriangleIds& shell, const TriangleTree& other)
{
  constexpr std::size_t samples = 1000;
  constexpr double touching = 1e-6; // a surface is about 1 long
  const std::size_t step = std::max<std::size_t>(1, shell.size() / samples);
  bool any = false;
  for (std::size_t i = 0; i < shell.size(); i += step)
  {
    const Triangle& triangle = mesh.Triangles[shell[i]];
    const Vector3 centroid = (1.0 / 3.0) *
      (mesh.Corner(triangle, 0) + mesh.Corner(triangle, 1) + mesh.Corner(triangle, 2));
    // Near the corners, which are the first to poke out.
    for (int corner = 0; corner < 3; ++corner)
    {
      const Vector3 point = centroid + 0.9 * (mesh.Corner(triangle, corner) - centroid);
      double distance = touching;
      TriangleTree::Nearest nearest;
      if (other.FindNearest(point, distance, nearest))
      {
        continue;
      }
      if (!(other.WindingNumber(point) > 0.5))
      {
        return false;
      }
      any = true;
    }
  }
  return any;
}

// In how many others each shell lies.
std::vector<int> FindDepths(const SurfaceMesh& mesh, const std::vector<TriangleIds>& shells,
  const std::function<bool()>& goOn)
{
  std::vector<MeshBounds> bounds;
  for (const TriangleIds& shell : shells)
  {
    bounds.push_back(BoundsOf(Submesh(mesh, shell)));
  }
  std::vector<int> depths(shells.size(), 0);
  for (std::size_t outer = 0; outer < shells.size(); ++outer)
  {
    if (!goOn())
    {
      return {};
    }
    std::unique_ptr<TriangleTree> tree;
    for (std::size_t inner = 0; inner < shells.size(); ++inner)
    {
      if (inner == outer || !bounds[outer].Contains(bounds[inner]))
      {
        continue;
      }
      if (!tree)
      {
        tree.reset(new TriangleTree(Submesh(mesh, shells[outer])));
      }
      depths[inner] += LiesWithin(mesh, shells[inner], *tree) ? 1 : 0;
    }
  }
  return depths;
}

// Of surfaces without double-sided facets.
bool OrientSingleSided(SurfaceMesh& mesh, EdgeTable&& edges, const std::function<bool()>& goOn)
{
  const std::vector<TriangleIds> shells = OrientEachShell(mesh, std::move(edges), goOn);
  const std::vector<int> depths = FindDepths(mesh, shells, goOn);
  if (depths.empty())
  {
    return false;
  }
  for (std::size_t i = 0; i < shells.size(); ++i)
  {
    for (std::size_t at = 0; depths[i] % 2 != 0 && at < shells[i].size(); ++at)
    {
      Flip(mesh.Triangles[shells[i][at]]);
    }
  }
  return true;
}
}

//------------------------------------------------------------------------------
bool OrientShells(SurfaceMesh& mesh, const std::function<bool()>& goOn)
{
  // The two triangles of a double-sided facet bound nothing together, and the surface around it
  // does not say which way either is oriented. So they are taken out and put back, one each way.
  EdgeTable edges(mesh);
  bool isBalanced = true;
  edges.ForEachUnbalanced(std::vector<std::int32_t>(mesh.Triangles.size(), 0),
    [&](const HalfEdge&) { isBalanced = false; });
  std::vector<Triangle> facets;
  if (!isBalanced)
  {
    facets = TakeDoubleSided(mesh);
    edges = EdgeTable(mesh);
  }
  const bool done = OrientSingleSided(mesh, std::move(edges), goOn);
  for (Triangle facet : facets)
  {
    mesh.Triangles.push_back(facet);
    Flip(facet);
    mesh.Triangles.push_back(facet);
  }
  return done;
}
}
