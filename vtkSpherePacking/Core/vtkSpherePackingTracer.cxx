// SPDX-License-Identifier: BSD-3-Clause
#include "vtkSpherePackingTracer.h"

#include "vtkSpherePackingCameraRays.h"
#include "vtkSpherePackingExtent.h"
#include "vtkSpherePackingFields.h"
#include "vtkSpherePackingInput.h"
#include "vtkSpherePackingMemory.h"
#include "vtkSpherePackingParallelFor.h"
#include "vtkSpherePackingPicture.h"
#include "vtkSpherePackingTiles.h"
#include "vtkSpherePackingTracerInternals.h"

#include "kernels/BuildBvh.h"
#include "kernels/RandomColor.h"

#include "vtkCamera.h"
#include "vtkErrorCode.h"
#include "vtkFieldData.h"
#include "vtkImageData.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkScalarsToColors.h"
#include "vtkStreamingDemandDrivenPipeline.h"
#include "vtkUnsignedCharArray.h"

#include <chrono>
#include <cmath>
#include <new>
#include <sstream>
#include <stdexcept>

vtkStandardNewMacro(vtkSpherePackingTracer);

namespace
{
using spherepacking::Bvh;
using spherepacking::GridTable;
using Seconds = std::chrono::duration<double>;

std::string Two(const int (&values)[2])
{
  return std::to_string(values[0]) + " " + std::to_string(values[1]);
}

spherepacking::Grid GridOf(vtkPolyData* packing, vtkDataArray* radii, std::int64_t cells)
{
  double bounds[6];
  vtkSpherePackingInput::ComputeBounds(packing, radii, bounds);
  return { { { bounds[0], bounds[2], bounds[4] }, { bounds[1], bounds[3], bounds[5] } }, cells };
}

// Twice as many cells as spheres, or fewer when these are so large that the lists become long.
spherepacking::Grid SuitableGrid(
  vtkPolyData* packing, vtkDataArray* radii, const spherepacking::SphereArrays& spheres)
{
  const double count = static_cast<double>(spheres.Count);
  double cells = std::max(1.0, std::ceil(std::cbrt(2.0 * count)));
  for (;;)
  {
    const auto grid = GridOf(packing, radii, static_cast<std::int64_t>(cells));
    if (cells <= 2.0 || spherepacking::EstimateTouches(grid, spheres) <= 64.0 * count)
    {
      return grid;
    }
    cells = std::floor(0.7 * cells);
  }
}

vtkMTimeType LastChange(vtkPolyData* packing, vtkAbstractArray* radii)
{
  vtkPoints* points = packing->GetPoints();
  return std::max({ points->GetMTime(), points->GetData()->GetMTime(), radii->GetMTime() });
}
}

//------------------------------------------------------------------------------
vtkSpherePackingTracer::vtkSpherePackingTracer()
  : Internals(new vtkSpherePackingTracerInternals)
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
int vtkSpherePackingTracer::Fail(const std::string& message)
{
  this->ErrorMessage = message;
  this->SetErrorCode(vtkErrorCode::UserError);
  vtkErrorMacro(<< message);
  return 0;
}

//------------------------------------------------------------------------------
void vtkSpherePackingTracer::Check() const
{
  if (this->WindowSize[0] < 1 || this->WindowSize[1] < 1)
  {
    throw std::invalid_argument(
      "window_size: found " + Two(this->WindowSize) + ", expected two numbers from 1 on");
  }
  if (this->TileSize[0] < 1 || this->TileSize[1] < 1)
  {
    throw std::invalid_argument(
      "tile: found " + Two(this->TileSize) + ", expected two numbers from 1 on");
  }
  const double pixels = static_cast<double>(this->WindowSize[0]) * this->WindowSize[1];
  if (pixels * this->BytesPerPixel() > vtkSpherePackingHalfOfMemory())
  {
    throw std::invalid_argument("window_size: found " + Two(this->WindowSize) +
      ", which is more than fits in half of the memory, expected fewer pixels");
  }
  if (!this->Camera)
  {
    throw std::invalid_argument("camera: found none, expected one");
  }
}

//------------------------------------------------------------------------------
bool vtkSpherePackingTracer::IsPrepared(vtkPolyData* packing) const
{
  const vtkSpherePackingTracerInternals& kept = *this->Internals;
  if (!kept.Radii || !packing || !packing->GetPoints())
  {
    return false;
  }
  vtkAbstractArray* radii =
    packing->GetPointData()->GetAbstractArray(this->RadiusArrayName.c_str());
  return kept.Points == packing->GetPoints()->GetData() && kept.Radii == radii &&
    kept.Time == LastChange(packing, radii) && kept.Structure == this->Structure &&
    kept.Cuts == this->Cuts;
}

//------------------------------------------------------------------------------
void vtkSpherePackingTracer::Prepare(vtkPolyData* packing)
{
  if (this->IsPrepared(packing))
  {
    return;
  }
  vtkNew<vtkSpherePackingInput> check;
  vtkDataArray* radii = check->FindRadii(packing, this->RadiusArrayName.c_str());
  if (*check->GetMessage())
  {
    throw std::invalid_argument(check->GetMessage());
  }
  vtkSpherePackingTracerInternals& kept = *this->Internals;
  kept = vtkSpherePackingTracerInternals();
  if (!radii)
  {
    return;
  }
  double bounds[6];
  vtkSpherePackingInput::ComputeBounds(packing, radii, bounds);
  vtkSpherePackingCheckExtent(bounds);
  const auto start = std::chrono::steady_clock::now();
  kept.Arrays.reset(new vtkSpherePackingArrays(packing, radii));
  this->BuildStructure(packing, radii);
  kept.BuildSeconds = Seconds(std::chrono::steady_clock::now() - start).count();
  kept.Points = packing->GetPoints()->GetData();
  kept.Radii = radii;
  kept.Time = LastChange(packing, radii);
  kept.Structure = this->Structure;
  kept.Cuts = this->Cuts;
}

//------------------------------------------------------------------------------
void vtkSpherePackingTracer::BuildStructure(vtkPolyData* packing, vtkDataArray* radii)
{
  vtkSpherePackingTracerInternals& kept = *this->Internals;
  const spherepacking::SphereArrays& spheres = kept.Arrays->Get();
  if (spheres.Count > std::numeric_limits<std::int32_t>::max())
  {
    throw std::invalid_argument(
      "packing: found " + std::to_string(spheres.Count) + " spheres, expected at most 2147483647");
  }
  if (this->Structure == BVH)
  {
    kept.Hierarchy.reset(new Bvh(spherepacking::BuildBvh(spheres, vtkSpherePackingParallelFor())));
  }
  else if (this->Structure == GRID)
  {
    if (this->Cuts < -1)
    {
      throw std::invalid_argument(
        "cuts: found " + std::to_string(this->Cuts) + ", expected 0 or more, or -1");
    }
    const spherepacking::Grid grid = this->Cuts < 0
      ? SuitableGrid(packing, radii, spheres)
      : GridOf(packing, radii, static_cast<std::int64_t>(this->Cuts) + 1);
    const double cells = std::pow(static_cast<double>(grid.Cells), 3.0);
    const double room = vtkSpherePackingHalfOfMemory();
    if (16.0 * cells > room || 16.0 * cells + 4.0 * EstimateTouches(grid, spheres) > room)
    {
      throw std::invalid_argument("cuts: found " + std::to_string(this->Cuts) +
        ", which makes more cells than fit in half of the memory with their spheres, expected "
        "fewer");
    }
    kept.Table.reset(
      new GridTable(spherepacking::BuildGrid(grid, spheres, vtkSpherePackingParallelFor())));
  }
}

//------------------------------------------------------------------------------
void vtkSpherePackingTracer::FindColors(vtkPolyData* packing)
{
  const vtkIdType count = packing->GetNumberOfPoints();
  std::vector<unsigned char>& colors = this->Internals->Colors;
  std::ostringstream state;
  vtkAbstractArray* array = packing->GetPointData()->GetAbstractArray(this->ColorArrayName.c_str());
  state << count << ' ' << this->RandomColors << ' ' << array << ' '
        << (array ? array->GetMTime() : 0) << ' ' << this->LookupTable.Get() << ' '
        << (this->LookupTable ? this->LookupTable->GetMTime() : 0) << std::hexfloat;
  for (const double share : this->Color)
  {
    state << ' ' << share;
  }
  if (this->Internals->ColorState == state.str())
  {
    return;
  }
  this->Internals->ColorState.clear();
  this->MapColors(packing, array, colors);
  this->Internals->ColorState = state.str();
}

//------------------------------------------------------------------------------
void vtkSpherePackingTracer::MapColors(
  vtkPolyData* packing, vtkAbstractArray* scalars, std::vector<unsigned char>& colors) const
{
  const vtkIdType count = packing->GetNumberOfPoints();
  colors.resize(4 * count);
  if (this->RandomColors)
  {
    for (vtkIdType i = 0; i < count; ++i)
    {
      spherepacking::RandomColor(static_cast<std::uint64_t>(i), &colors[4 * i]);
    }
    return;
  }
  if (this->ColorArrayName.empty() || count == 0)
  {
    unsigned char color[4] = { 0, 0, 0, 255 };
    for (int channel = 0; channel < 3; ++channel)
    {
      // NaN becomes 0.
      const double share = std::min(std::max(0.0, this->Color[channel]), 1.0);
      color[channel] = static_cast<unsigned char>(255.0 * share + 0.5);
    }
    for (vtkIdType i = 0; i < count; ++i)
    {
      std::copy_n(color, 4, &colors[4 * i]);
    }
    return;
  }
  if (!scalars || scalars->GetNumberOfTuples() != count)
  {
    throw std::invalid_argument("scalars: the packing has no point array '" + this->ColorArrayName +
      "' with a value for each sphere, expected the name of one");
  }
  vtkSmartPointer<vtkScalarsToColors> table = this->LookupTable;
  if (!table)
  {
    table = vtkSmartPointer<vtkScalarsToColors>::New();
    vtkDataArray* numbers = vtkDataArray::SafeDownCast(scalars);
    double range[2] = { 0.0, 1.0 };
    if (numbers)
    {
      numbers->GetFiniteRange(range, numbers->GetNumberOfComponents() == 1 ? 0 : -1);
    }
    table->SetRange(range);
  }
  const auto mapped = vtkSmartPointer<vtkUnsignedCharArray>::Take(
    table->MapScalars(scalars, VTK_COLOR_MODE_DEFAULT, -1, VTK_RGBA));
  std::copy_n(mapped->GetPointer(0), colors.size(), colors.begin());
}

//------------------------------------------------------------------------------
int vtkSpherePackingTracer::RequestData(
  vtkInformation*, vtkInformationVector** inputs, vtkInformationVector* outputs)
{
  this->ErrorMessage.clear();
  this->SetErrorCode(vtkErrorCode::NoError);
  try
  {
    this->Check();
    vtkPolyData* packing = vtkPolyData::GetData(inputs[0]);
    this->Prepare(packing);
    this->FindColors(packing);
    this->Trace(vtkImageData::GetData(outputs));
  }
  catch (const std::invalid_argument& error)
  {
    return this->Fail(error.what());
  }
  catch (const std::bad_alloc&)
  {
    return this->Fail("the picture or the structure does not fit in the memory that is free");
  }
  return 1;
}

//------------------------------------------------------------------------------
void vtkSpherePackingTracer::Trace(vtkImageData* output)
{
  vtkSpherePackingCameraRays camera;
  this->SetRays(camera);
  output->SetExtent(0, this->WindowSize[0] - 1, 0, this->WindowSize[1] - 1, 0, 0);
  const spherepacking::Picture picture = vtkSpherePackingAddPicture(output);

  const spherepacking::Scene scene = this->Internals->Scene();
  vtkSpherePackingTiles tiles(this->WindowSize, this->TileSize);
  const auto left = tiles.Run([&](const spherepacking::Tile& tile)
    { spherepacking::TraceTile(scene, camera.Rays, camera.ToEye, this->Samples, tile, picture); },
    [this](double share)
    {
      this->UpdateProgress(share);
      return this->CheckAbort();
    });
  // The executive would throw away what is done.
  this->SetAbortOutput(false);
  for (const spherepacking::Tile& tile : left)
  {
    vtkSpherePackingShowNothing(picture, tile);
  }
  vtkSpherePackingAddExtents(output, tiles.Tiles);
  vtkSpherePackingAddField(output, "compute_seconds", tiles.ComputeSeconds);
  vtkSpherePackingAddField(output, "partial_seconds", tiles.PartialSeconds);
  vtkSpherePackingAddField(output, "complete_seconds", { tiles.CompleteSeconds });
  vtkSpherePackingAddField(output, "build_seconds", { this->Internals->BuildSeconds });
  vtkSpherePackingAddField(output, "memory_bytes", { this->Internals->Bytes() });
}

//------------------------------------------------------------------------------
vtkIdType vtkSpherePackingTracer::CastRay(
  const double origin[3], const double direction[3], double& t, double normal[3])
{
  spherepacking::Ray ray;
  std::copy_n(origin, 3, ray.O);
  std::copy_n(direction, 3, ray.D);
  return this->Cast(ray, t, normal);
}

//------------------------------------------------------------------------------
vtkIdType vtkSpherePackingTracer::CastPixel(double x, double y, double& t, double normal[3])
{
  vtkSpherePackingCameraRays camera;
  try
  {
    this->Check();
    this->SetRays(camera);
  }
  catch (const std::invalid_argument& error)
  {
    this->Fail(error.what());
    return -1;
  }
  return this->Cast(camera.Rays.At(x, y), t, normal);
}

//------------------------------------------------------------------------------
void vtkSpherePackingTracer::SetRays(vtkSpherePackingCameraRays& camera)
{
  if (!camera.Set(this->Camera, this->WindowSize[0], this->WindowSize[1]))
  {
    throw std::invalid_argument("camera: found one without a picture, expected finite numbers, a "
                                "position away from the focal point, a view-up that is not the "
                                "direction of view, and an angle or a scale above 0");
  }
}

//------------------------------------------------------------------------------
vtkIdType vtkSpherePackingTracer::Cast(const spherepacking::Ray& ray, double& t, double normal[3])
{
  this->ErrorMessage.clear();
  this->SetErrorCode(vtkErrorCode::NoError);
  t = spherepacking::NoHit;
  std::fill_n(normal, 3, 0.0);
  try
  {
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
  }
  catch (const std::invalid_argument& error)
  {
    this->Fail(error.what());
    return -1;
  }
  const spherepacking::Scene scene = this->Internals->Scene();
  const spherepacking::Hit hit = spherepacking::FirstHit(scene, ray);
  if (hit.Id >= 0)
  {
    t = hit.T;
    double n[3];
    spherepacking::NormalAt(ray, scene.Spheres[hit.Id], spherepacking::InverseSquare(ray), n);
    std::copy_n(n, 3, normal);
  }
  return hit.Id;
}

//------------------------------------------------------------------------------
void vtkSpherePackingTracer::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Camera: " << this->Camera.Get() << "\n";
  os << indent << "WindowSize: " << Two(this->WindowSize) << "\n";
  os << indent << "Structure: " << this->Structure << "\n";
  os << indent << "Cuts: " << this->Cuts << "\n";
  os << indent << "Samples: " << this->Samples << "\n";
  os << indent << "TileSize: " << Two(this->TileSize) << "\n";
  os << indent << "RadiusArrayName: " << this->RadiusArrayName << "\n";
  os << indent << "ColorArrayName: " << this->ColorArrayName << "\n";
  os << indent << "LookupTable: " << this->LookupTable.Get() << "\n";
  os << indent << "Color: " << this->Color[0] << " " << this->Color[1] << " " << this->Color[2]
     << "\n";
  os << indent << "RandomColors: " << (this->RandomColors ? "On" : "Off") << "\n";
  os << indent << "ErrorMessage: " << this->ErrorMessage << "\n";
}
