// SPDX-License-Identifier: BSD-3-Clause
#include "packer/LineCrossing.h"
#include "packer/TriangleTree.h"

#include <algorithm>

namespace spherepacking
{
namespace
{
constexpr double Pi = 3.14159265358979323846;
// Distance over size from which a group of triangles counts as a dipole.
constexpr double Far = 1.5;
// What the dipoles of a surface that is seen once are wrong by then.
constexpr double FarError = 0.15;
constexpr double Farthest = 1e4;
constexpr std::size_t MostCaps = 64;
}

//------------------------------------------------------------------------------
double SolidAngle(const Vector3& place, const Vector3 (&corners)[3])
{
  const Vector3 a = corners[0] - place;
  const Vector3 b = corners[1] - place;
  const Vector3 c = corners[2] - place;
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
  ForEachEdgeGroup(EdgesOf(mesh),
    [&](const MeshEdge* first, const MeshEdge* last)
    {
      const auto forward = static_cast<int>(
        std::count_if(first, last, [](const MeshEdge& edge) { return edge.Forward; }));
      const int times = 2 * forward - static_cast<int>(last - first);
      if (times != 0 && this->Caps.size() <= MostCaps)
      {
        apex = apex ? apex : &mesh.Points[first->Low];
        this->Caps.push_back(
          { { { *apex, mesh.Points[first->High], mesh.Points[first->Low] } }, times });
      }
    });
  this->IsCapped = this->Caps.size() <= MostCaps;
}

//------------------------------------------------------------------------------
bool TriangleTree::IsInside(const Vector3& place) const
{
  if (this->IsCapped)
  {
    for (const AxisLine& line : this->ShortestLines(place))
    {
      int turns = 0;
      if (this->SumCrossings(line, turns))
      {
        double caps = 0.0;
        for (const Cap& cap : this->Caps)
        {
          caps += cap.Times * SolidAngle(place, cap.Triangle.Of);
        }
        return turns - caps > 0.5;
      }
    }
  }
  return this->WindingNumber(place) > 0.5;
}

//------------------------------------------------------------------------------
std::array<AxisLine, 3> TriangleTree::ShortestLines(const Vector3& place) const
{
  const Node& root = this->Nodes.front();
  std::array<AxisLine, 3> lines;
  double lengths[3];
  for (int axis = 0; axis < 3; ++axis)
  {
    const double up = root.High[axis] - place[axis];
    const double down = place[axis] - root.Low[axis];
    lines[axis] = { place, axis, up < down ? 1 : -1 };
    lengths[axis] = std::min(up, down);
  }
  std::sort(lines.begin(), lines.end(),
    [&](const AxisLine& a, const AxisLine& b) { return lengths[a.Axis] < lengths[b.Axis]; });
  return lines;
}

//------------------------------------------------------------------------------
bool TriangleTree::SumCrossings(const AxisLine& line, int& turns) const
{
  const int first = (line.Axis + 1) % 3;
  const int second = (line.Axis + 2) % 3;
  const Vector3& start = line.Start;
  std::int32_t open[2 * MostDepth];
  int count = 0;
  open[count++] = 0;
  while (count > 0)
  {
    const std::int32_t at = open[--count];
    const Node& node = this->Nodes[at];
    const bool ahead = line.Sense > 0 ? node.High[line.Axis] >= start[line.Axis]
                                      : node.Low[line.Axis] <= start[line.Axis];
    if (!ahead || start[first] < node.Low[first] || start[first] > node.High[first] ||
      start[second] < node.Low[second] || start[second] > node.High[second])
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
      const LineCrossing crossing = CrossingOf(line, this->Triangles[i].Of);
      if (!crossing.IsCertain)
      {
        return false;
      }
      turns += crossing.Turns;
    }
  }
  for (const Cap& cap : this->Caps)
  {
    const LineCrossing crossing = CrossingOf(line, cap.Triangle.Of);
    if (!crossing.IsCertain)
    {
      return false;
    }
    turns += cap.Times * crossing.Turns;
  }
  return true;
}

//------------------------------------------------------------------------------
double TriangleTree::WindingNumber(const Vector3& place) const
{
  for (double far = Far;; far *= 2.0)
  {
    double dipoles = 0.0;
    const double sum = this->SumAngles(place, far, dipoles);
    const double error = FarError * std::max(1.0, dipoles) * (Far / far) * (Far / far);
    if (dipoles == 0.0 || std::abs(sum - 0.5) > error || far > Farthest)
    {
      return sum;
    }
  }
}

//------------------------------------------------------------------------------
double TriangleTree::SumAngles(const Vector3& place, double far, double& dipoles) const
{
  std::int32_t open[2 * MostDepth];
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
    const Vector3 away = node.Middle - place;
    const double distance = Length(away);
    if (distance > far * node.Radius)
    {
      const double angle = Dot(away, node.Area) / (4.0 * Pi * distance * distance * distance);
      sum += angle;
      dipoles += std::abs(angle);
    }
    else if (node.Child < 0)
    {
      for (std::int32_t i = node.First; i < node.First + node.Count; ++i)
      {
        sum += SolidAngle(place, this->Triangles[i].Of);
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
