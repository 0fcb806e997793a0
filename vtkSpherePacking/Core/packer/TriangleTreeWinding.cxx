// SPDX-License-Identifier: BSD-3-Clause
#include "packer/EdgeTable.h"
#include "packer/RayCrossing.h"
#include "packer/TriangleTree.h"

#include <algorithm>

namespace spherepacking
{
namespace
{
constexpr double Pi = 3.14159265358979323846;
// Barill et al.'s beta: distance over radius from which a node counts as a dipole.
constexpr double MinimumBeta = 1.5;
constexpr double MaximumBeta = 1e4;
// Estimate of the dipoles' error at the minimum, for a surface that covers the sphere of directions
// once; it falls with the square of beta.
constexpr double DipoleError = 0.15;
constexpr std::size_t MaximumCaps = 64;
}

//------------------------------------------------------------------------------
double SolidAngle(const Vector3& point, const Vector3 (&corners)[3])
{
  const Vector3 a = corners[0] - point;
  const Vector3 b = corners[1] - point;
  const Vector3 c = corners[2] - point;
  const double la = Length(a);
  const double lb = Length(b);
  const double lc = Length(c);
  const double above = Dot(a, Cross(b, c));
  const double below = la * lb * lc + Dot(a, b) * lc + Dot(b, c) * la + Dot(c, a) * lb;
  return std::atan2(above, below) / (2.0 * Pi);
}

//------------------------------------------------------------------------------
void TriangleTree::MakeCaps(const SurfaceMesh& mesh)
{
  const Vector3* apex = nullptr;
  EdgeTable(mesh).ForEachEdge(
    [&](const HalfEdge* first, const HalfEdge* last)
    {
      const int net = NetDirection(first, last);
      if (net != 0 && this->Caps.size() <= MaximumCaps)
      {
        apex = apex ? apex : &mesh.Points[first->Low];
        this->Caps.push_back(
          { { { *apex, mesh.Points[first->High], mesh.Points[first->Low] } }, net });
      }
    });
  this->IsCapped = this->Caps.size() <= MaximumCaps;
}

//------------------------------------------------------------------------------
bool TriangleTree::IsInside(const Vector3& point) const
{
  if (this->IsCapped)
  {
    for (const AxisRay& ray : this->ShortestRays(point))
    {
      int sum = 0;
      if (this->SumCrossings(ray, sum))
      {
        double caps = 0.0;
        for (const Cap& cap : this->Caps)
        {
          caps += cap.Multiplicity * SolidAngle(point, cap.Triangle.Of);
        }
        return sum - caps > 0.5;
      }
    }
  }
  return this->WindingNumber(point) > 0.5;
}

//------------------------------------------------------------------------------
std::array<AxisRay, 3> TriangleTree::ShortestRays(const Vector3& point) const
{
  const Node& root = this->Nodes.front();
  std::array<AxisRay, 3> rays;
  double lengths[3];
  for (int axis = 0; axis < 3; ++axis)
  {
    const double up = root.High[axis] - point[axis];
    const double down = point[axis] - root.Low[axis];
    rays[axis] = { point, axis, up < down ? 1 : -1 };
    lengths[axis] = std::min(up, down);
  }
  std::sort(rays.begin(), rays.end(),
    [&](const AxisRay& a, const AxisRay& b) { return lengths[a.Axis] < lengths[b.Axis]; });
  return rays;
}

//------------------------------------------------------------------------------
bool TriangleTree::SumCrossings(const AxisRay& ray, int& sum) const
{
  const int first = (ray.Axis + 1) % 3;
  const int second = (ray.Axis + 2) % 3;
  const Vector3& origin = ray.Origin;
  std::int32_t open[2 * MaximumDepth];
  int count = 0;
  open[count++] = 0;
  while (count > 0)
  {
    const std::int32_t at = open[--count];
    const Node& node = this->Nodes[at];
    const bool ahead = ray.Sense > 0 ? node.High[ray.Axis] >= origin[ray.Axis]
                                     : node.Low[ray.Axis] <= origin[ray.Axis];
    if (!ahead || origin[first] < node.Low[first] || origin[first] > node.High[first] ||
      origin[second] < node.Low[second] || origin[second] > node.High[second])
    {
      continue;
    }
    if (node.Child >= 0)
    {
      open[count++] = node.Child;
      open[count++] = at + 1;
      continue;
    }
    for (std::int32_t i = node.First; i < node.First + node.Count; ++i)
    {
      const RayCrossing crossing = Intersect(ray, this->Triangles[i].Of);
      if (!crossing.IsCertain)
      {
        return false;
      }
      sum += crossing.Sign;
    }
  }
  for (const Cap& cap : this->Caps)
  {
    const RayCrossing crossing = Intersect(ray, cap.Triangle.Of);
    if (!crossing.IsCertain)
    {
      return false;
    }
    sum += cap.Multiplicity * crossing.Sign;
  }
  return true;
}

//------------------------------------------------------------------------------
double TriangleTree::WindingNumber(const Vector3& point) const
{
  for (double beta = MinimumBeta;; beta *= 2.0)
  {
    double dipoles = 0.0;
    const double sum = this->SumSolidAngles(point, beta, dipoles);
    const double error =
      DipoleError * std::max(1.0, dipoles) * (MinimumBeta / beta) * (MinimumBeta / beta);
    if (dipoles == 0.0 || std::abs(sum - 0.5) > error || beta > MaximumBeta)
    {
      return sum;
    }
  }
}

//------------------------------------------------------------------------------
double TriangleTree::SumSolidAngles(const Vector3& point, double beta, double& dipoles) const
{
  std::int32_t open[2 * MaximumDepth];
  int count = 0;
  double sum = 0.0;
  if (!this->Nodes.empty())
  {
    open[count++] = 0;
  }
  while (count > 0)
  {
    const std::int32_t at = open[--count];
    const Node& node = this->Nodes[at];
    const Vector3 away = node.Centroid - point;
    const double distance = Length(away);
    if (distance > beta * node.Radius)
    {
      const double angle = Dot(away, node.Area) / (4.0 * Pi * distance * distance * distance);
      sum += angle;
      dipoles += std::abs(angle);
    }
    else if (node.Child < 0)
    {
      for (std::int32_t i = node.First; i < node.First + node.Count; ++i)
      {
        sum += SolidAngle(point, this->Triangles[i].Of);
      }
    }
    else
    {
      open[count++] = node.Child;
      open[count++] = at + 1;
    }
  }
  return sum;
}
}
