// SPDX-License-Identifier: BSD-3-Clause
#include "bridge/SurfaceInput.h"

#include "packer/EdgeTable.h"
#include "packer/RepairMesh.h"

#include "vtkCell.h"
#include "vtkGenericCell.h"
#include "vtkIdList.h"
#include "vtkNew.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkStaticPointLocator.h"

#include <cmath>
#include <limits>
#include <stdexcept>
#include <string>

namespace spherepacking
{
namespace
{
// Checked before vtkPolyData::GetCell() reads the points, which it does unchecked.
void CheckIds(vtkPolyData* surface, vtkIdType cell, vtkIdList* ids)
{
  surface->GetCellPoints(cell, ids);
  for (vtkIdType i = 0; i < ids->GetNumberOfIds(); ++i)
  {
    const vtkIdType id = ids->GetId(i);
    if (id < 0 || id >= surface->GetNumberOfPoints())
    {
      throw std::invalid_argument("surface: found point " + std::to_string(id) + " in cell " +
        std::to_string(cell) + ", expected one of " + std::to_string(surface->GetNumberOfPoints()));
    }
  }
}

std::vector<Vector3> PointsOf(vtkPolyData* surface)
{
  std::vector<Vector3> points(static_cast<std::size_t>(surface->GetNumberOfPoints()));
  for (vtkIdType i = 0; i < surface->GetNumberOfPoints(); ++i)
  {
    double point[3];
    surface->GetPoint(i, point);
    if (!std::isfinite(point[0] + point[1] + point[2]))
    {
      throw std::invalid_argument("surface: found coordinates of point " + std::to_string(i) +
        " that are not finite, expected numbers");
    }
    points[i] = { point[0], point[1], point[2] };
  }
  return points;
}

SurfaceMesh MeshOf(vtkPolyData* surface)
{
  SurfaceMesh mesh;
  mesh.Points = PointsOf(surface);
  vtkNew<vtkGenericCell> cell;
  vtkNew<vtkIdList> corners;
  for (vtkIdType i = 0; i < surface->GetNumberOfCells(); ++i)
  {
    CheckIds(surface, i, corners);
    surface->GetCell(i, cell);
    if (cell->GetCellDimension() != 2)
    {
      continue;
    }
    cell->TriangulateIds(0, corners);
    for (vtkIdType corner = 0; corner + 2 < corners->GetNumberOfIds(); corner += 3)
    {
      mesh.Triangles.push_back({ static_cast<std::int32_t>(corners->GetId(corner)),
        static_cast<std::int32_t>(corners->GetId(corner + 1)),
        static_cast<std::int32_t>(corners->GetId(corner + 2)) });
    }
  }
  return mesh;
}

// Merges points that are nearly the same, as in files with few digits.
void MergeNearPoints(SurfaceMesh& mesh)
{
  constexpr double tolerance = 1e-7; // of the longest side: far below the smallest radius
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  points->SetNumberOfPoints(static_cast<vtkIdType>(mesh.Points.size()));
  for (std::size_t i = 0; i < mesh.Points.size(); ++i)
  {
    points->SetPoint(
      static_cast<vtkIdType>(i), mesh.Points[i].X, mesh.Points[i].Y, mesh.Points[i].Z);
  }
  vtkNew<vtkPolyData> cloud;
  cloud->SetPoints(points);
  vtkNew<vtkStaticPointLocator> locator;
  locator->SetDataSet(cloud);
  locator->BuildLocator();
  std::vector<vtkIdType> merged(mesh.Points.size());
  locator->MergePoints(tolerance * BoundsOf(mesh).LongestSide(), merged.data());
  MergePoints(mesh, std::vector<std::int32_t>(merged.begin(), merged.end()));
}

bool IsClosed(const SurfaceMesh& mesh)
{
  return !mesh.Triangles.empty() && DescribeOpenEdges(mesh).empty();
}

// Where the surface is closed, nearly coincident points and double-sided facets may both be meant,
// so it stays as it is.
void Close(SurfaceMesh& mesh)
{
  const std::string open = DescribeOpenEdges(mesh);
  for (const bool merges : { false, true })
  {
    if (merges)
    {
      MergeNearPoints(mesh);
    }
    if (IsClosed(mesh))
    {
      return;
    }
    SurfaceMesh single = mesh;
    DropDuplicates(single);
    if (IsClosed(single))
    {
      mesh = std::move(single);
      return;
    }
  }
  throw std::invalid_argument("surface: found " + open + ", expected a closed surface");
}
}

//------------------------------------------------------------------------------
SurfaceMesh ClosedMeshOf(vtkPolyData* surface)
{
  if (surface->GetNumberOfPoints() > std::numeric_limits<std::int32_t>::max())
  {
    throw std::invalid_argument("surface: found more than 2147483647 points, expected fewer");
  }
  SurfaceMesh mesh = MeshOf(surface);
  MergeCoincidentPoints(mesh);
  if (mesh.Triangles.empty())
  {
    throw std::invalid_argument("surface: found no triangles, expected a closed surface");
  }
  Close(mesh);
  if (mesh.Triangles.size() > std::numeric_limits<std::int32_t>::max() / 3)
  {
    throw std::invalid_argument("surface: found more than 715827882 triangles, expected fewer");
  }
  return mesh;
}
}
