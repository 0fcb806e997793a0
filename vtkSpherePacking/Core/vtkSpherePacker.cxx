// SPDX-License-Identifier: BSD-3-Clause
#include "vtkSpherePacker.h"

#include "bridge/FieldData.h"
#include "bridge/Guard.h"
#include "bridge/SmpParallelFor.h"

#include "bridge/PackingArrays.h"
#include "packer/OrientShells.h"
#include "packer/PackSpheres.h"

#include "vtkCell.h"
#include "vtkCellArray.h"
#include "vtkGenericCell.h"
#include "vtkIdList.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkStaticPointLocator.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>

vtkStandardNewMacro(vtkSpherePacker);

using spherepacking::PackedSphere;
using spherepacking::Refuse;
using spherepacking::SurfaceMesh;
using spherepacking::Vector3;

namespace
{
// Lengths about 1 around the origin: what is far away loses no digits in between, and what is very
// large or small does not leave the range of single precision.
struct Frame
{
  Vector3 Middle;
  double Unit; // a power of two

  explicit Frame(const SurfaceMesh& mesh)
  {
    const spherepacking::MeshBox box = spherepacking::BoxOf(mesh);
    const double most = box.LongestSide();
    this->Middle = box.Middle();
    this->Unit = most > 0.0 ? std::exp2(std::round(std::log2(most))) : 1.0;
  }

  // How far rounding may move a point.
  double Rounding() const
  {
    const double most = std::max(
      std::max(std::abs(this->Middle.X), std::abs(this->Middle.Y)), std::abs(this->Middle.Z));
    return 2.0 * std::numeric_limits<double>::epsilon() * (most + this->Unit);
  }
};

// Cells are not looked at before their points are known to be there.
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

// All polygons and strips as triangles; other cells are left out.
SurfaceMesh MeshOf(vtkPolyData* surface)
{
  SurfaceMesh mesh;
  mesh.Points.resize(static_cast<std::size_t>(surface->GetNumberOfPoints()));
  for (vtkIdType i = 0; i < surface->GetNumberOfPoints(); ++i)
  {
    double point[3];
    surface->GetPoint(i, point);
    if (!std::isfinite(point[0] + point[1] + point[2]))
    {
      throw std::invalid_argument("surface: found coordinates of point " + std::to_string(i) +
        " that are not finite, expected numbers");
    }
    mesh.Points[i] = { point[0], point[1], point[2] };
  }
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

// Replaces points that are nearly the same, as in files with few digits, by one of them.
void MergeNearPoints(SurfaceMesh& mesh)
{
  constexpr double near = 1e-7; // of the longest side: far less than spheres keep away
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
  locator->MergePoints(near * spherepacking::BoxOf(mesh).LongestSide(), merged.data());
  spherepacking::ReplacePoints(mesh, std::vector<std::int32_t>(merged.begin(), merged.end()));
}

// Real surfaces have points that are nearly the same, and triangles twice. Neither is touched where
// the surface is closed: both may be meant.
void Close(SurfaceMesh& mesh)
{
  const std::string open = spherepacking::DescribeOpenEdges(mesh);
  for (const bool near : { false, true })
  {
    if (near)
    {
      MergeNearPoints(mesh);
    }
    if (!mesh.Triangles.empty() && spherepacking::DescribeOpenEdges(mesh).empty())
    {
      return;
    }
    SurfaceMesh single = mesh;
    spherepacking::DropCopies(single);
    if (!single.Triangles.empty() && spherepacking::DescribeOpenEdges(single).empty())
    {
      mesh = std::move(single);
      return;
    }
  }
  throw std::invalid_argument("surface: found " + open + ", expected a closed surface");
}

// A closed surface.
SurfaceMesh PrepareMesh(vtkPolyData* surface)
{
  if (surface->GetNumberOfPoints() > std::numeric_limits<std::int32_t>::max())
  {
    throw std::invalid_argument("surface: found more than 2147483647 points, expected fewer");
  }
  SurfaceMesh mesh = MeshOf(surface);
  spherepacking::MergePoints(mesh);
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

void FillOutput(const std::vector<PackedSphere>& spheres, const Frame& frame, vtkPolyData* output)
{
  spherepacking::PackingArrays arrays(static_cast<vtkIdType>(spheres.size()), false);
  double* centers = arrays.Centres<double>();
  double* radii = arrays.Radii<double>();
  for (const PackedSphere& sphere : spheres)
  {
    for (int axis = 0; axis < 3; ++axis)
    {
      *centers++ = frame.Middle[axis] + frame.Unit * sphere.Center[axis];
    }
    *radii++ = frame.Unit * sphere.Radius - frame.Rounding();
  }
  arrays.MoveTo(output);
}

double VolumeOf(const std::vector<PackedSphere>& spheres)
{
  double volume = 0.0;
  for (const PackedSphere& sphere : spheres)
  {
    volume += 4.0 / 3.0 * 3.14159265358979323846 * std::pow(sphere.Radius, 3);
  }
  return volume;
}
}

//------------------------------------------------------------------------------
int vtkSpherePacker::RequestData(
  vtkInformation*, vtkInformationVector** inputs, vtkInformationVector* outputs)
{
  this->Interrupted = false;
  vtkPolyData* output = vtkPolyData::GetData(outputs);
  const auto work = [&] { this->Pack(vtkPolyData::GetData(inputs[0]), output); };
  if (spherepacking::RunGuarded(this, this->ErrorMessage,
        "count: not enough memory for so many spheres, expected fewer",
        work) == spherepacking::Outcome::Failed)
  {
    output->Initialize();
    return 0;
  }
  return 1;
}

//------------------------------------------------------------------------------
std::function<bool()> vtkSpherePacker::Watch()
{
  return [this, sinceLast = spherepacking::Stopwatch()]() mutable
  {
    // Observers may take longer than what is watched.
    if (sinceLast.Seconds() > 0.05)
    {
      this->UpdateProgress(0.0);
      sinceLast = spherepacking::Stopwatch();
    }
    return this->GetAbortExecute() == 0;
  };
}

//------------------------------------------------------------------------------
void vtkSpherePacker::Pack(vtkPolyData* surface, vtkPolyData* output)
{
  const spherepacking::Stopwatch watch;
  if (this->NumberOfSpheres < 1)
  {
    Refuse("count", this->NumberOfSpheres, "1 or more");
  }
  if (!(this->MinimumRadius >= 0.0 && std::isfinite(this->MinimumRadius)))
  {
    Refuse("min_radius", this->MinimumRadius, "a finite number from 0 on");
  }
  if (!(this->VolumeFraction > 0.0 && this->VolumeFraction <= 1.0))
  {
    Refuse("fraction", this->VolumeFraction, "a number above 0 and up to 1");
  }
  SurfaceMesh mesh = PrepareMesh(surface);
  const Frame frame(mesh);
  for (Vector3& point : mesh.Points)
  {
    point = (1.0 / frame.Unit) * (point - frame.Middle);
  }
  if (!spherepacking::OrientShells(mesh, this->Watch()))
  {
    this->Interrupted = true;
    output->Initialize();
    return;
  }
  const double volume = mesh.Volume();
  const double cube = frame.Unit * frame.Unit * frame.Unit;
  if (!(volume > 1e-12))
  {
    Refuse("surface", volume * cube, "a surface that encloses a volume");
  }
  spherepacking::PackingGoal goal;
  goal.Count = this->NumberOfSpheres;
  // What is written is smaller by what rounding may do, see FillOutput().
  goal.LeastRadius =
    std::max(this->MinimumRadius / frame.Unit, 1e-6) + frame.Rounding() / frame.Unit;
  // Of surfaces that cross themselves the volume is no measure of what is inside.
  goal.Volume = this->VolumeFraction < 1.0 ? this->VolumeFraction * volume
                                           : std::numeric_limits<double>::infinity();
  goal.Seed = static_cast<std::uint64_t>(static_cast<std::uint32_t>(this->Seed));
  const auto progress = [&](std::int64_t count, double filled)
  {
    const double volumes = this->VolumeFraction < 1.0 ? filled / goal.Volume : 0.0;
    this->UpdateProgress(std::min(1.0, std::max(static_cast<double>(count) / goal.Count, volumes)));
    this->Interrupted = this->GetAbortExecute() != 0;
    return !this->Interrupted;
  };
  const std::vector<PackedSphere> spheres =
    spherepacking::PackSpheres(mesh, goal, spherepacking::SmpParallelFor(), progress);
  if (spheres.empty() && !this->Interrupted)
  {
    if (this->MinimumRadius > 0.0)
    {
      Refuse("min_radius", this->MinimumRadius, "less: no sphere above that was found to fit");
    }
    throw std::invalid_argument("surface: found no sphere of a millionth of its size that fits, "
                                "expected a thicker one");
  }
  FillOutput(spheres, frame, output);
  spherepacking::AddFieldArray(output, "surface_volume", { volume * cube });
  const double filled = VolumeOf(spheres) / volume;
  spherepacking::AddFieldArray(output, "volume_fraction",
    { filled > 1.0 ? std::numeric_limits<double>::quiet_NaN() : filled });
  spherepacking::AddFieldArray(output, "build_seconds", { watch.Seconds() });
}

//------------------------------------------------------------------------------
void vtkSpherePacker::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "NumberOfSpheres: " << this->NumberOfSpheres << "\n";
  os << indent << "MinimumRadius: " << this->MinimumRadius << "\n";
  os << indent << "VolumeFraction: " << this->VolumeFraction << "\n";
  os << indent << "Seed: " << this->Seed << "\n";
  os << indent << "Interrupted: " << this->Interrupted << "\n";
  os << indent << "ErrorMessage: " << this->ErrorMessage << "\n";
}
