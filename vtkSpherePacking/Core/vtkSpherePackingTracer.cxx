// SPDX-License-Identifier: BSD-3-Clause
#include "vtkSpherePackingTracer.h"

#include "bridge/CameraView.h"
#include "bridge/FieldData.h"
#include "bridge/Guard.h"
#include "bridge/MemoryLimit.h"
#include "bridge/PictureArrays.h"
#include "bridge/PreparedScene.h"
#include "bridge/TileLoop.h"

#include "vtkCamera.h"
#include "vtkImageData.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkObjectFactory.h"
#include "vtkPolyData.h"
#include "vtkScalarsToColors.h"
#include "vtkStreamingDemandDrivenPipeline.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <stdexcept>
#include <string>

vtkStandardNewMacro(vtkSpherePackingTracer);

using spherepacking::AddFieldArray;
using spherepacking::Join;
using spherepacking::Outcome;
using spherepacking::Ray;
using spherepacking::RunGuarded;
using spherepacking::Tile;

namespace
{
constexpr char OutOfMemory[] =
  "the picture or the structure does not fit in the memory that is free";
}

//------------------------------------------------------------------------------
vtkSpherePackingTracer::vtkSpherePackingTracer()
  : Prepared(new spherepacking::PreparedScene)
{
}

//------------------------------------------------------------------------------
vtkSpherePackingTracer::~vtkSpherePackingTracer() = default;

//------------------------------------------------------------------------------
void vtkSpherePackingTracer::SetCamera(vtkCamera* camera)
{
  if (this->Camera != camera)
  {
    this->Camera = camera;
    this->Modified();
  }
}

//------------------------------------------------------------------------------
vtkCamera* vtkSpherePackingTracer::GetCamera()
{
  return this->Camera;
}

//------------------------------------------------------------------------------
void vtkSpherePackingTracer::SetLookupTable(vtkScalarsToColors* table)
{
  if (this->LookupTable != table)
  {
    this->LookupTable = table;
    this->Modified();
  }
}

//------------------------------------------------------------------------------
vtkScalarsToColors* vtkSpherePackingTracer::GetLookupTable()
{
  return this->LookupTable;
}

//------------------------------------------------------------------------------
vtkMTimeType vtkSpherePackingTracer::GetMTime()
{
  vtkMTimeType time = this->Superclass::GetMTime();
  for (vtkObject* part :
    { static_cast<vtkObject*>(this->Camera), static_cast<vtkObject*>(this->LookupTable) })
  {
    time = part ? std::max(time, part->GetMTime()) : time;
  }
  return time;
}

//------------------------------------------------------------------------------
int vtkSpherePackingTracer::FillInputPortInformation(int, vtkInformation* info)
{
  info->Set(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), "vtkPolyData");
  return 1;
}

//------------------------------------------------------------------------------
int vtkSpherePackingTracer::RequestInformation(
  vtkInformation*, vtkInformationVector**, vtkInformationVector* outputs)
{
  vtkInformation* info = outputs->GetInformationObject(0);
  const int extent[6] = { 0, this->WindowSize[0] - 1, 0, this->WindowSize[1] - 1, 0, 0 };
  info->Set(vtkStreamingDemandDrivenPipeline::WHOLE_EXTENT(), extent, 6);
  info->Set(vtkDataObject::SPACING(), 1.0, 1.0, 1.0);
  info->Set(vtkDataObject::ORIGIN(), 0.0, 0.0, 0.0);
  return 1;
}

//------------------------------------------------------------------------------
void vtkSpherePackingTracer::Check() const
{
  if (this->WindowSize[0] < 1 || this->WindowSize[1] < 1)
  {
    spherepacking::Refuse("window_size", Join(this->WindowSize, 2), "two numbers from 1 on");
  }
  if (this->TileSize[0] < 1 || this->TileSize[1] < 1)
  {
    spherepacking::Refuse("tile", Join(this->TileSize, 2), "two numbers from 1 on");
  }
  const double pixels = static_cast<double>(this->WindowSize[0]) * this->WindowSize[1];
  const double most = std::floor(spherepacking::HalfOfMemory() / this->BytesPerPixel());
  if (pixels > most)
  {
    throw std::invalid_argument("window_size: found " + Join(this->WindowSize, 2) +
      ", which is more than fits in half of the memory, expected at most " +
      std::to_string(static_cast<std::int64_t>(most)) + " pixels");
  }
  if (!this->Camera)
  {
    throw std::invalid_argument("camera: found none, expected one");
  }
}

//------------------------------------------------------------------------------
void vtkSpherePackingTracer::Prepare(vtkPolyData* packing)
{
  this->Prepared->Prepare(packing,
    { this->RadiusArrayName.c_str(), static_cast<spherepacking::StructureKind>(this->Structure),
      this->Cuts });
}

//------------------------------------------------------------------------------
void vtkSpherePackingTracer::UpdateColors(vtkPolyData* packing)
{
  this->Prepared->SetColors(packing,
    { this->ColorArrayName, this->LookupTable, { this->Color[0], this->Color[1], this->Color[2] },
      this->RandomColors });
}

//------------------------------------------------------------------------------
int vtkSpherePackingTracer::RequestData(
  vtkInformation*, vtkInformationVector** inputs, vtkInformationVector* outputs)
{
  const auto work = [&]
  {
    this->Check();
    vtkPolyData* packing = vtkPolyData::GetData(inputs[0]);
    this->Prepare(packing);
    this->UpdateColors(packing);
    this->Trace(vtkImageData::GetData(outputs));
  };
  return RunGuarded(this, this->ErrorMessage, OutOfMemory, work) == Outcome::Failed ? 0 : 1;
}

//------------------------------------------------------------------------------
void vtkSpherePackingTracer::Trace(vtkImageData* output)
{
  const spherepacking::CameraView view = this->FindView();
  output->SetExtent(0, this->WindowSize[0] - 1, 0, this->WindowSize[1] - 1, 0, 0);
  const spherepacking::Picture picture = spherepacking::AddPictureArrays(output);

  const spherepacking::Scene scene = this->Prepared->Get();
  spherepacking::TileLoop tiles(this->WindowSize, this->TileSize);
  const auto missing = tiles.Run([&](const Tile& tile)
    { spherepacking::TraceTile(scene, view.Rays, view.ToEye, this->Samples, tile, picture); },
    [this](double fraction)
    {
      this->UpdateProgress(fraction);
      return this->CheckAbort();
    });
  // The executive would throw away what is done.
  this->SetAbortOutput(false);
  for (const Tile& tile : missing)
  {
    spherepacking::ClearTile(picture, tile);
  }
  spherepacking::AddTileExtents(output, tiles.Tiles);
  AddFieldArray(output, "compute_seconds", tiles.ComputeSeconds);
  AddFieldArray(output, "partial_seconds", tiles.PartialSeconds);
  AddFieldArray(output, "complete_seconds", { tiles.CompleteSeconds });
  AddFieldArray(output, "build_seconds", { this->Prepared->BuildSeconds() });
  AddFieldArray(output, "memory_bytes", { this->Prepared->StructureBytes() });
}

//------------------------------------------------------------------------------
vtkIdType vtkSpherePackingTracer::CastRay(
  const double origin[3], const double direction[3], double& t, double normal[3])
{
  const auto makeRay = [&]
  {
    Ray ray;
    std::copy_n(origin, 3, ray.O);
    std::copy_n(direction, 3, ray.D);
    return ray;
  };
  return this->Cast(makeRay, t, normal);
}

//------------------------------------------------------------------------------
vtkIdType vtkSpherePackingTracer::CastPixel(double x, double y, double& t, double normal[3])
{
  const auto makeRay = [&]
  {
    this->Check();
    return this->FindView().Rays.At(x, y);
  };
  return this->Cast(makeRay, t, normal);
}

//------------------------------------------------------------------------------
spherepacking::CameraView vtkSpherePackingTracer::FindView() const
{
  spherepacking::CameraView view;
  if (!view.Set(this->Camera, this->WindowSize[0], this->WindowSize[1]))
  {
    throw std::invalid_argument("camera: found one without a picture, expected finite numbers, a "
                                "position away from the focal point, a view-up that is not the "
                                "direction of view, and an angle or a scale above 0");
  }
  return view;
}

//------------------------------------------------------------------------------
vtkIdType vtkSpherePackingTracer::Cast(
  const std::function<Ray()>& makeRay, double& t, double normal[3])
{
  t = spherepacking::NoHit;
  std::fill_n(normal, 3, 0.0);
  vtkIdType id = -1;
  const auto work = [&]
  {
    const Ray ray = makeRay();
    const double square = spherepacking::Dot(ray.D, ray.D);
    if (!(square > 0.0) || !std::isfinite(square + ray.O[0] + ray.O[1] + ray.O[2]))
    {
      throw std::invalid_argument(
        "ray: found numbers that are not finite or a direction of length 0, expected a ray");
    }
    if (this->GetNumberOfInputConnections(0) == 0)
    {
      throw std::invalid_argument("packing: found none, expected one");
    }
    this->GetInputAlgorithm()->Update();
    this->Prepare(vtkPolyData::SafeDownCast(this->GetInput()));
    const spherepacking::Scene scene = this->Prepared->Get();
    const spherepacking::Hit hit = spherepacking::FirstHit(scene, ray);
    id = hit.Id;
    if (hit.Id >= 0)
    {
      t = hit.T;
      double n[3];
      // Not that of the arrays, which may have been written to since.
      const spherepacking::Sphere& on = hit.On;
      const double sphere[4] = { on.X, on.Y, on.Z, on.R };
      std::copy_n(sphere, 4, this->CastSphere);
      spherepacking::NormalAt(ray, on, spherepacking::InverseSquare(ray), hit.T, n);
      std::copy_n(n, 3, normal);
    }
  };
  RunGuarded(this, this->ErrorMessage, OutOfMemory, work);
  return id;
}

//------------------------------------------------------------------------------
void vtkSpherePackingTracer::NoticeChanges()
{
  this->Prepared->NoticeChanges();
}

//------------------------------------------------------------------------------
void vtkSpherePackingTracer::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Camera: " << this->Camera.Get() << "\n";
  os << indent << "WindowSize: " << Join(this->WindowSize, 2) << "\n";
  os << indent << "Structure: " << this->Structure << "\n";
  os << indent << "Cuts: " << this->Cuts << "\n";
  os << indent << "Samples: " << this->Samples << "\n";
  os << indent << "TileSize: " << Join(this->TileSize, 2) << "\n";
  os << indent << "RadiusArrayName: " << this->RadiusArrayName << "\n";
  os << indent << "ColorArrayName: " << this->ColorArrayName << "\n";
  os << indent << "LookupTable: " << this->LookupTable.Get() << "\n";
  os << indent << "Color: " << this->Color[0] << " " << this->Color[1] << " " << this->Color[2]
     << "\n";
  os << indent << "RandomColors: " << (this->RandomColors ? "On" : "Off") << "\n";
  os << indent << "CastSphere: " << this->CastSphere[0] << " " << this->CastSphere[1] << " "
     << this->CastSphere[2] << " " << this->CastSphere[3] << "\n";
  os << indent << "ErrorMessage: " << this->ErrorMessage << "\n";
}
