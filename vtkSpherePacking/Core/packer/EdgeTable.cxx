// SPDX-License-Identifier: BSD-3-Clause
#include "packer/EdgeTable.h"

#include <algorithm>
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
}

//------------------------------------------------------------------------------
int NetDirection(const HalfEdge* first, const HalfEdge* last)
{
  const auto forward = static_cast<int>(
    std::count_if(first, last, [](const HalfEdge& halfEdge) { return halfEdge.Forward; }));
  return 2 * forward - static_cast<int>(last - first);
}

//------------------------------------------------------------------------------
EdgeTable::EdgeTable(const SurfaceMesh& mesh)
{
  this->HalfEdges.reserve(3 * mesh.Triangles.size());
  for (std::size_t i = 0; i < mesh.Triangles.size(); ++i)
  {
    for (int side = 0; side < 3; ++side)
    {
      const std::int32_t from = mesh.Triangles[i][side];
      const std::int32_t to = mesh.Triangles[i][(side + 1) % 3];
      this->HalfEdges.push_back(
        { std::min(from, to), std::max(from, to), static_cast<std::int32_t>(i), from < to });
    }
  }
  std::sort(this->HalfEdges.begin(), this->HalfEdges.end(), [](const HalfEdge& a, const HalfEdge& b)
    { return std::tie(a.Low, a.High, a.Triangle) < std::tie(b.Low, b.High, b.Triangle); });
}

//------------------------------------------------------------------------------
std::string DescribeOpenEdges(const SurfaceMesh& mesh)
{
  std::int64_t open = 0;
  Vector3 ends[2];
  EdgeTable(mesh).ForEachEdge(
    [&](const HalfEdge* first, const HalfEdge* last)
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
