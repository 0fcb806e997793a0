// SPDX-License-Identifier: BSD-3-Clause
#include "impostor/DrawOrder.h"

#include <algorithm>
#include <cmath>

namespace spherepacking
{
namespace
{
constexpr double SquareSize = 64.0; // pixels
// The fractions of a square's clusters, front to back, at which the batches end. The first batch is
// the smallest, since nothing culls it.
constexpr double BatchEnds[] = { 0.2, 0.5, 1.0 };

struct ProjectedCluster
{
  int Square;
  double Depth;
  const SphereCluster* Cluster;
};

// Projects the middle of a cluster. False for a cluster outside of the depth range.
bool Project(const SphereCluster& cluster, const PointSprites& sprites, const ViewTransform& view,
  ProjectedCluster& projected)
{
  std::array<double, 3> middle;
  double half2 = 0.0;
  for (int axis = 0; axis < 3; ++axis)
  {
    const double low = cluster.Bounds[2 * axis];
    const double high = cluster.Bounds[2 * axis + 1];
    middle[axis] = 0.5 * (low + high) - sprites.GetOrigin()[axis];
    half2 += 0.25 * (high - low) * (high - low);
  }
  const double radius = std::sqrt(half2) * view.RadiusScale; // of the sphere around the box
  const std::array<double, 3> c = view.ToView(middle);
  const double depth = -c[2];
  if (depth + radius < view.Near || depth - radius > view.Far)
  {
    return false;
  }
  const double scale = view.Parallel ? 1.0 : 1.0 / std::max(depth, view.Near);
  int square[2];
  for (int axis = 0; axis < 2; ++axis)
  {
    const double pixel = view.SlopeToPixel[axis] * c[axis] * scale + view.SlopeToPixel[2 + axis];
    square[axis] = static_cast<int>(std::clamp(pixel, 0.0, view.Viewport[2 + axis]) / SquareSize);
  }
  projected = { square[1] * (1 + static_cast<int>(view.Viewport[2] / SquareSize)) + square[0],
    depth, &cluster };
  return true;
}

// The clusters in the depth range, square by square and front to back in each.
std::vector<ProjectedCluster> SortByDepth(const PointSprites& sprites, const ViewTransform& view)
{
  std::vector<ProjectedCluster> clusters;
  clusters.reserve(sprites.GetClusters().size());
  for (const SphereCluster& cluster : sprites.GetClusters())
  {
    ProjectedCluster projected;
    if (Project(cluster, sprites, view, projected))
    {
      clusters.push_back(projected);
    }
  }
  std::sort(clusters.begin(), clusters.end(),
    [](const ProjectedCluster& a, const ProjectedCluster& b)
    { return a.Square != b.Square ? a.Square < b.Square : a.Depth < b.Depth; });
  return clusters;
}
}

//------------------------------------------------------------------------------
void DrawRanges::Add(vtkIdType begin, vtkIdType end)
{
  this->Firsts.push_back(static_cast<int>(begin));
  this->Counts.push_back(static_cast<int>(end - begin));
}

//------------------------------------------------------------------------------
std::vector<DrawRanges> MakeDrawOrder(const PointSprites& sprites, const ViewTransform& view)
{
  const vtkIdType count = static_cast<vtkIdType>(sprites.GetPointIds().size());
  if (count < ManySpheres)
  {
    std::vector<DrawRanges> all(1);
    all[0].Add(0, count);
    return all;
  }
  const std::vector<ProjectedCluster> clusters = SortByDepth(sprites, view);
  std::vector<DrawRanges> batches(std::size(BatchEnds));
  for (auto begin = clusters.begin(); begin != clusters.end();)
  {
    const auto end = std::find_if(begin, clusters.end(),
      [&](const ProjectedCluster& other) { return other.Square != begin->Square; });
    const double total = static_cast<double>(end - begin);
    int batch = 0;
    for (auto at = begin; at != end; ++at)
    {
      while (static_cast<double>(at - begin) >= BatchEnds[batch] * total)
      {
        ++batch;
      }
      batches[batch].Add(at->Cluster->Begin, at->Cluster->End);
    }
    begin = end;
  }
  return batches;
}
}
