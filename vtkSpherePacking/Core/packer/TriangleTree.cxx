// SPDX-License-Identifier: BSD-3-Clause
#include "packer/TriangleTree.h"

#include <algorithm>
#include <limits>

namespace spherepacking
{
namespace
{
constexpr std::int32_t TrianglesPerLeaf = 4;
}

//------------------------------------------------------------------------------
Vector3 NearestOnTriangle(const Vector3& point, const Vector3 (&corners)[3])
{
  const Vector3& a = corners[0];
  const Vector3& b = corners[1];
  const Vector3& c = corners[2];
  const Vector3 ab = b - a;
  const Vector3 ac = c - a;
  const double d1 = Dot(ab, point - a);
  const double d2 = Dot(ac, point - a);
  if (d1 <= 0.0 && d2 <= 0.0)
  {
    return a;
  }
  const double d3 = Dot(ab, point - b);
  const double d4 = Dot(ac, point - b);
  if (d3 >= 0.0 && d4 <= d3)
  {
    return b;
  }
  const double d5 = Dot(ab, point - c);
  const double d6 = Dot(ac, point - c);
  if (d6 >= 0.0 && d5 <= d6)
  {
    return c;
  }
  const double ofC = d1 * d4 - d3 * d2;
  if (ofC <= 0.0 && d1 >= 0.0 && d3 <= 0.0)
  {
    return a + (d1 > d3 ? d1 / (d1 - d3) : 0.0) * ab;
  }
  const double ofB = d5 * d2 - d1 * d6;
  if (ofB <= 0.0 && d2 >= 0.0 && d6 <= 0.0)
  {
    return a + (d2 > d6 ? d2 / (d2 - d6) : 0.0) * ac;
  }
  const double ofA = d3 * d6 - d5 * d4;
  const double toC = d4 - d3;
  const double toB = d5 - d6;
  if (ofA <= 0.0 && toC >= 0.0 && toB >= 0.0)
  {
    return b + (toC + toB > 0.0 ? toC / (toC + toB) : 0.0) * (c - b);
  }
  const double scale = 1.0 / (ofA + ofB + ofC);
  return a + (ofB * scale) * ab + (ofC * scale) * ac;
}

//------------------------------------------------------------------------------
TriangleTree::TriangleTree(const SurfaceMesh& mesh)
{
  this->Triangles.reserve(mesh.Triangles.size());
  for (const Triangle& triangle : mesh.Triangles)
  {
    this->Triangles.push_back(
      { { mesh.Corner(triangle, 0), mesh.Corner(triangle, 1), mesh.Corner(triangle, 2) } });
  }
  if (!this->Triangles.empty())
  {
    this->Build(0, static_cast<std::int32_t>(this->Triangles.size()));
    this->MakeCaps(mesh);
  }
}

//------------------------------------------------------------------------------
std::int32_t TriangleTree::Build(std::int32_t first, std::int32_t count)
{
  const auto at = static_cast<std::int32_t>(this->Nodes.size());
  Node node;
  node.First = first;
  node.Count = count;
  this->Measure(node);
  this->Nodes.push_back(node);
  if (count <= TrianglesPerLeaf)
  {
    return at;
  }
  int axis = 0;
  for (int other = 1; other < 3; ++other)
  {
    axis = node.High[other] - node.Low[other] > node.High[axis] - node.Low[axis] ? other : axis;
  }
  const auto centroid = [axis](const Corners& corners)
  { return corners.Of[0][axis] + corners.Of[1][axis] + corners.Of[2][axis]; };
  const auto begin = this->Triangles.begin() + first;
  std::nth_element(begin, begin + count / 2, begin + count,
    [&](const Corners& a, const Corners& b) { return centroid(a) < centroid(b); });
  this->Build(first, count / 2);
  const std::int32_t child = this->Build(first + count / 2, count - count / 2);
  this->Nodes[at].Child = child;
  return at;
}

//------------------------------------------------------------------------------
void TriangleTree::Measure(Node& node) const
{
  std::fill_n(node.Low, 3, std::numeric_limits<double>::infinity());
  std::fill_n(node.High, 3, -std::numeric_limits<double>::infinity());
  double areas = 0.0;
  const Corners* triangles = this->Triangles.data() + node.First;
  for (std::int32_t i = 0; i < node.Count; ++i)
  {
    const Vector3(&corners)[3] = triangles[i].Of;
    for (int axis = 0; axis < 3; ++axis)
    {
      for (const Vector3& corner : corners)
      {
        node.Low[axis] = std::min(node.Low[axis], corner[axis]);
        node.High[axis] = std::max(node.High[axis], corner[axis]);
      }
    }
    const Vector3 area = 0.5 * Cross(corners[1] - corners[0], corners[2] - corners[0]);
    node.Area = node.Area + area;
    areas += Length(area);
    node.Centroid = node.Centroid + (Length(area) / 3.0) * (corners[0] + corners[1] + corners[2]);
  }
  const Vector3 low = { node.Low[0], node.Low[1], node.Low[2] };
  const Vector3 high = { node.High[0], node.High[1], node.High[2] };
  node.Centroid = areas > 0.0 ? (1.0 / areas) * node.Centroid : 0.5 * (low + high);
  for (std::int32_t i = 0; i < node.Count; ++i)
  {
    for (const Vector3& corner : triangles[i].Of)
    {
      node.Radius = std::max(node.Radius, Length(corner - node.Centroid));
    }
  }
}

//------------------------------------------------------------------------------
double TriangleTree::SquaredDistanceToBox(const Node& node, const Vector3& point)
{
  double square = 0.0;
  for (int axis = 0; axis < 3; ++axis)
  {
    const double outside =
      std::max(std::max(node.Low[axis] - point[axis], point[axis] - node.High[axis]), 0.0);
    square += outside * outside;
  }
  return square;
}

//------------------------------------------------------------------------------
bool TriangleTree::FindNearest(const Vector3& point, double& distance, Nearest& nearest) const
{
  struct Entry
  {
    std::int32_t Node;
    double Square;
  };
  Entry open[2 * MaximumDepth];
  int count = 0;
  double best = distance * distance;
  bool found = false;
  const auto test = [&](std::int32_t triangle)
  {
    const Vector3 on = NearestOnTriangle(point, this->Triangles[triangle].Of);
    const Vector3 away = point - on;
    const double square = Dot(away, away);
    if (square < best)
    {
      best = square;
      nearest = { on, triangle };
      found = true;
    }
  };
  if (nearest.Triangle >= 0)
  {
    test(nearest.Triangle);
  }
  if (!this->Nodes.empty())
  {
    open[count++] = { 0, SquaredDistanceToBox(this->Nodes[0], point) };
  }
  while (count > 0)
  {
    const Entry entry = open[--count];
    if (!(entry.Square < best))
    {
      continue;
    }
    const Node& node = this->Nodes[entry.Node];
    if (node.Child < 0)
    {
      for (std::int32_t i = node.First; i < node.First + node.Count; ++i)
      {
        test(i);
      }
      continue;
    }
    Entry near = { entry.Node + 1, SquaredDistanceToBox(this->Nodes[entry.Node + 1], point) };
    Entry far = { node.Child, SquaredDistanceToBox(this->Nodes[node.Child], point) };
    if (far.Square < near.Square)
    {
      std::swap(near, far);
    }
    open[count++] = far;
    open[count++] = near;
  }
  if (found)
  {
    distance = std::sqrt(best);
  }
  return found;
}

//------------------------------------------------------------------------------
TriangleTree::Nearest TriangleTree::NearestOn(
  std::int32_t triangle, const Vector3& point, bool& inside) const
{
  const Vector3(&corners)[3] = this->Triangles[triangle].Of;
  const Vector3 normal = Cross(corners[1] - corners[0], corners[2] - corners[0]);
  inside = Dot(point - corners[0], normal) < 0.0;
  return { NearestOnTriangle(point, corners), triangle };
}

//------------------------------------------------------------------------------
Vector3 TriangleTree::NormalOf(std::int32_t triangle) const
{
  const Vector3(&corners)[3] = this->Triangles[triangle].Of;
  const Vector3 area = Cross(corners[1] - corners[0], corners[2] - corners[0]);
  const double length = Length(area);
  return length > 0.0 ? (1.0 / length) * area : Vector3{ 0.0, 0.0, 1.0 };
}
}
