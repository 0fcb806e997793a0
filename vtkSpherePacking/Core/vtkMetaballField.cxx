// SPDX-License-Identifier: BSD-3-Clause
#include "vtkMetaballField.h"

#include "bridge/CoordinateRange.h"
#include "bridge/EncloseSurface.h"
#include "bridge/FieldData.h"
#include "bridge/GridGeometry.h"
#include "bridge/Guard.h"
#include "bridge/InterruptibleFor.h"
#include "bridge/Limits.h"
#include "bridge/PackingCharges.h"
#include "bridge/RadiusArray.h"
#include "bridge/RunInterruptibly.h"
#include "bridge/SmpParallelFor.h"

#include "vtkFloatArray.h"
#include "vtkImageData.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkSMPTools.h"
#include "vtkStreamingDemandDrivenPipeline.h"
#include "vtkTypeInt64Array.h"
#include "vtkUnsignedCharArray.h"

#include <algorithm>
#include <stdexcept>

vtkStandardNewMacro(vtkMetaballField);

using spherepacking::AbortRequest;
using spherepacking::BlobKind;
using spherepacking::FieldBlock;
using spherepacking::FieldScene;
using spherepacking::GridGeometry;
using spherepacking::Join;
using spherepacking::Outcome;
using spherepacking::PackingCharges;
using spherepacking::Refuse;
using spherepacking::Report;
using spherepacking::RunGuarded;
using spherepacking::Stopwatch;

// The grid of the last run, and when that on which it depends had changed last.
struct vtkMetaballField::CachedGrid
{
  GridGeometry Grid;
  std::vector<vtkMTimeType> Times;
};

namespace
{
void MultiplyBy(double factor, vtkFloatArray* array)
{
  float* values = array->GetPointer(0);
  if (factor != 1.0)
  {
    vtkSMPTools::Transform(values, values + array->GetNumberOfValues(), values,
      [factor](float value) { return static_cast<float>(value * factor); });
  }
}

template <typename ArrayT>
ArrayT* AddArray(vtkImageData* output, const char* name, int components)
{
  vtkNew<ArrayT> array;
  array->SetName(name);
  array->SetNumberOfComponents(components);
  array->SetNumberOfTuples(output->GetNumberOfPoints());
  array->FillValue(0);
  output->GetPointData()->AddArray(array);
  return array;
}
}

//------------------------------------------------------------------------------
vtkMetaballField::vtkMetaballField()
  : Cached(new CachedGrid)
{
}

//------------------------------------------------------------------------------
vtkMetaballField::~vtkMetaballField() = default;

//------------------------------------------------------------------------------
void vtkMetaballField::SetNumberOfWeights(int number)
{
  const auto size = static_cast<std::size_t>(std::max(0, number));
  if (size != this->Weights.size())
  {
    const auto outOfMemory = []
    { return std::string("weights: found more than fit in the memory that is free"); };
    RunGuarded(this, this->ErrorMessage, outOfMemory, [&] { this->Weights.resize(size, 1.0); });
    this->Modified();
  }
}

//------------------------------------------------------------------------------
void vtkMetaballField::SetWeight(int i, double weight)
{
  if (i < 0 || i >= this->GetNumberOfWeights())
  {
    vtkErrorMacro(<< "weight " << i << ": there are " << this->GetNumberOfWeights());
  }
  else if (this->Weights[i] != weight)
  {
    this->Weights[i] = weight;
    this->Modified();
  }
}

//------------------------------------------------------------------------------
double vtkMetaballField::GetWeight(int i) const
{
  return i >= 0 && i < this->GetNumberOfWeights() ? this->Weights[i] : 0.0;
}

//------------------------------------------------------------------------------
int vtkMetaballField::FillInputPortInformation(int, vtkInformation* info)
{
  info->Set(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), "vtkPolyData");
  return 1;
}

//------------------------------------------------------------------------------
spherepacking::GridRequest vtkMetaballField::Request() const
{
  spherepacking::GridRequest request;
  std::copy_n(this->Dimensions, 3, request.Dimensions);
  std::copy_n(this->Spacing, 3, request.Spacing);
  std::copy_n(this->ModelBounds, 6, request.ModelBounds);
  request.Threshold = this->Threshold;
  request.Kind = static_cast<BlobKind>(this->Kernel);
  request.BytesPerPoint = 4.0 + 12.0 * this->ComputeGradient + 8.0 * this->ComputeStrongest +
    7.0 * !this->ColorArrayName.empty();
  return request;
}

//------------------------------------------------------------------------------
void vtkMetaballField::CheckOptions() const
{
  spherepacking::CheckGridRequest(this->Request());
  if (this->Count < 0)
  {
    Refuse("count", this->Count, "0 or more");
  }
  for (const double weight : this->Weights)
  {
    if (!(weight >= 0.0 && weight <= spherepacking::MaxWeight))
    {
      Refuse("weights", Join(this->Weights.data(), this->GetNumberOfWeights()),
        "numbers from 0 to 1e20");
    }
  }
  const double error = this->RelativeError;
  if (!(error == 0.0 ||
        (error >= spherepacking::MinRelativeError && error <= spherepacking::MaxRelativeError)))
  {
    Refuse("relative_error", error, "a number from 2e-5 to 0.5, or 0");
  }
}

//------------------------------------------------------------------------------
int vtkMetaballField::RequestInformation(
  vtkInformation*, vtkInformationVector**, vtkInformationVector* outputs)
{
  // The grid depends on the packing, and filters downstream ask for it before there is data.
  GridGeometry grid{ {}, { 1.0, 1.0, 1.0 }, { 1, 1, 1 } };
  const auto work = [&]
  {
    this->CheckOptions();
    this->GetInputAlgorithm()->Update();
    vtkPolyData* packing = vtkPolyData::SafeDownCast(this->GetInput());
    grid = this->FindGrid(packing, spherepacking::RadiiOf(packing, this->RadiusArrayName));
  };
  // RequestData() meets the same error.
  RunGuarded(this, this->ErrorMessage, [this] { return this->OutOfMemory(); }, work, Report::Later);
  vtkInformation* info = outputs->GetInformationObject(0);
  const int extent[6] = { 0, grid.Dimensions[0] - 1, 0, grid.Dimensions[1] - 1, 0,
    grid.Dimensions[2] - 1 };
  info->Set(vtkStreamingDemandDrivenPipeline::WHOLE_EXTENT(), extent, 6);
  info->Set(vtkDataObject::ORIGIN(), grid.Origin, 3);
  info->Set(vtkDataObject::SPACING(), grid.Spacing, 3);
  vtkDataObject::SetPointDataActiveScalarInfo(info, VTK_FLOAT, 1);
  return 1;
}

//------------------------------------------------------------------------------
const GridGeometry& vtkMetaballField::FindGrid(vtkPolyData* packing, vtkDataArray* radii)
{
  const std::vector<vtkMTimeType> times{ this->GetMTime(), packing->GetMTime(),
    radii ? radii->GetMTime() : 0,
    packing->GetPoints() ? packing->GetPoints()->GetData()->GetMTime() : 0 };
  if (this->Cached->Times != times)
  {
    this->Cached->Times.clear();
    const auto work = [&](std::atomic<double>&)
    {
      const PackingCharges charges(packing, radii, this->Count, this->Weights);
      if (!charges.Empty())
      {
        spherepacking::CheckCoordinateRange(charges.Bounds);
      }
      this->Cached->Grid = spherepacking::ResolveGrid(this->Request(), charges);
    };
    spherepacking::RunInterruptibly(this, packing->GetNumberOfPoints(), work);
    this->Cached->Times = times;
  }
  return this->Cached->Grid;
}

//------------------------------------------------------------------------------
std::string vtkMetaballField::OutOfMemory() const
{
  return std::string(this->Spacing[0] > 0.0 ? "spacing" : "dimensions") +
    ": found a field that does not fit in the memory that is free, expected fewer points";
}

//------------------------------------------------------------------------------
int vtkMetaballField::RequestData(
  vtkInformation*, vtkInformationVector** inputs, vtkInformationVector* outputs)
{
  vtkImageData* output = vtkImageData::GetData(outputs);
  const auto work = [&]
  {
    this->CheckOptions();
    vtkPolyData* packing = vtkPolyData::GetData(inputs[0]);
    vtkDataArray* radii = spherepacking::RadiiOf(packing, this->RadiusArrayName);
    spherepacking::CheckCount(packing->GetNumberOfPoints());
    const PackingCharges charges(packing, radii, this->Count, this->Weights);
    vtkUnsignedCharArray* colors = this->FindColors(packing);
    const GridGeometry grid = this->FindGrid(packing, radii);
    output->SetDimensions(grid.Dimensions);
    output->SetOrigin(grid.Origin);
    output->SetSpacing(grid.Spacing);
    this->FillOutput(charges, grid, colors, output);
    // Else the executive would discard the blocks that are done.
    this->SetAbortOutput(false);
  };
  if (RunGuarded(
        this, this->ErrorMessage, [this] { return this->OutOfMemory(); }, work) == Outcome::Failed)
  {
    output->Initialize();
    return 0;
  }
  return 1;
}

//------------------------------------------------------------------------------
FieldScene vtkMetaballField::Prepare(const PackingCharges& charges, const GridGeometry& geometry,
  const unsigned char* colors, int channel, int components)
{
  double all[6];
  for (int axis = 0; axis < 3; ++axis)
  {
    const double last =
      geometry.Origin[axis] + (geometry.Dimensions[axis] - 1) * geometry.Spacing[axis];
    all[2 * axis] = charges.Empty() ? geometry.Origin[axis]
                                    : std::min(geometry.Origin[axis], charges.Bounds[2 * axis]);
    all[2 * axis + 1] = charges.Empty() ? last : std::max(last, charges.Bounds[2 * axis + 1]);
  }
  double origin[3];
  double scale;
  spherepacking::FindUnitScale(all, origin, scale);
  std::vector<spherepacking::Charge> spheres = charges.Scaled(origin, scale);
  for (spherepacking::Charge& sphere : spheres)
  {
    sphere.Strength *=
      colors ? colors[static_cast<vtkIdType>(sphere.Id) * components + channel] / 255.0f : 1.0f;
  }
  spherepacking::FieldGrid grid;
  for (int axis = 0; axis < 3; ++axis)
  {
    grid.Origin[axis] = (geometry.Origin[axis] - origin[axis]) * scale;
    grid.Spacing[axis] = geometry.Spacing[axis] * scale;
    grid.Dimensions[axis] = geometry.Dimensions[axis];
  }
  grid.Scale = scale;
  // A channel of a blend needs the field alone.
  const spherepacking::FieldWanted wanted{ !colors && this->ComputeGradient,
    !colors && this->ComputeStrongest };
  FieldScene scene;
  const auto number = static_cast<std::int64_t>(spheres.size());
  spherepacking::RunInterruptibly(this, number,
    [&](std::atomic<double>&)
    {
      scene = spherepacking::PrepareField(static_cast<BlobKind>(this->Kernel), std::move(spheres),
        this->RelativeError, grid, wanted, spherepacking::SmpParallelFor());
    });
  return scene;
}

//------------------------------------------------------------------------------
bool vtkMetaballField::SumBlocks(const FieldScene& scene, Blocks blocks, double from, double to)
{
  Stopwatch sinceLast;
  bool stopped = false;
  spherepacking::InterruptibleFor(
    blocks.Last - blocks.First,
    [&](std::int64_t i)
    {
      spherepacking::SumField(scene, blocks.First[i]);
      if (scene.Grid.Strongest)
      {
        spherepacking::FindStrongest(scene, blocks.First[i]);
      }
    },
    [&](std::int64_t, double fraction)
    {
      // Observers may take longer than a block.
      if (fraction >= 1.0 || sinceLast.Seconds() > 0.01)
      {
        this->UpdateProgress(from + (to - from) * fraction);
        sinceLast = Stopwatch();
      }
      stopped = stopped || this->CheckAbort();
      return stopped;
    });
  return !stopped;
}

//------------------------------------------------------------------------------
void vtkMetaballField::FillOutput(const PackingCharges& charges, const GridGeometry& geometry,
  vtkUnsignedCharArray* colors, vtkImageData* output)
{
  const Stopwatch watch;
  FieldScene scene;
  bool completed = true;
  try
  {
    scene = this->Prepare(charges, geometry, nullptr, 0, 0);
  }
  catch (const AbortRequest&)
  {
    completed = false;
  }
  const double build = watch.Seconds();
  const auto meshes = static_cast<double>(scene.Hierarchy ? scene.Hierarchy->Levels.size() : 0);
  // A blend needs three more fields.
  const double progress = colors ? 0.25 : 1.0;
  vtkFloatArray* field = AddArray<vtkFloatArray>(output, "field", 1);
  scene.Grid.Field = field->GetPointer(0);
  vtkFloatArray* gradient = nullptr;
  if (this->ComputeGradient)
  {
    gradient = AddArray<vtkFloatArray>(output, "gradient", 3);
    scene.Grid.Gradient = gradient->GetPointer(0);
  }
  if (this->ComputeStrongest)
  {
    auto* strongest = AddArray<vtkTypeInt64Array>(output, "strongest", 1);
    strongest->FillValue(-1);
    scene.Grid.Strongest = strongest->GetPointer(0);
  }
  if (completed)
  {
    const std::vector<FieldBlock> blocks = spherepacking::CutIntoBlocks(scene);
    completed =
      this->SumBlocks(scene, { blocks.data(), blocks.data() + blocks.size() }, 0.0, progress);
  }
  // The charges have weights divided by the largest.
  const double unit = charges.MaxWeight > 0.0 ? charges.MaxWeight : 1.0;
  MultiplyBy(unit, field);
  if (gradient)
  {
    MultiplyBy(unit * scene.Grid.Scale, gradient);
  }
  if (colors)
  {
    scene = FieldScene();
    auto* blend = AddArray<vtkUnsignedCharArray>(output, "blend", 3);
    for (int channel = 0; completed && channel < 3; ++channel)
    {
      completed = this->Blend(charges, geometry, colors, channel, field, blend);
    }
  }
  output->GetPointData()->SetActiveScalars("field");
  spherepacking::AddFieldArray(output, "meshes", { meshes });
  spherepacking::AddFieldArray(output, "build_seconds", { build });
  spherepacking::AddFieldArray(output, "sum_seconds", { watch.Seconds() - build });
}

//------------------------------------------------------------------------------
bool vtkMetaballField::Blend(const PackingCharges& charges, const GridGeometry& geometry,
  vtkUnsignedCharArray* colors, int channel, vtkFloatArray* field, vtkUnsignedCharArray* blend)
{
  // Blocks at a time: enough for all cores, and few enough for a small array of what they make.
  constexpr std::ptrdiff_t together = 16;
  FieldScene scene;
  try
  {
    scene = this->Prepare(
      charges, geometry, colors->GetPointer(0), channel, colors->GetNumberOfComponents());
  }
  catch (const AbortRequest&)
  {
    return false;
  }
  const std::vector<FieldBlock> blocks = spherepacking::CutIntoBlocks(scene);
  const double unit = charges.MaxWeight > 0.0 ? charges.MaxWeight : 1.0;
  const double progress = 0.25 / static_cast<double>(blocks.size());
  const FieldBlock* const end = blocks.data() + blocks.size();
  std::vector<float> weighted;
  bool completed = true;
  for (const FieldBlock* first = blocks.data(); completed && first < end;)
  {
    const FieldBlock* last = first;
    while (last < end && (last - first < together || last->First[2] == last[-1].First[2]))
    {
      ++last; // in whole layers, whose points are contiguous
    }
    spherepacking::FieldGrid& grid = scene.Grid;
    grid.FirstIndex = 0;
    const std::int64_t low = grid.Index(0, 0, first->First[2]);
    const std::int64_t high = grid.Index(0, 0, last[-1].First[2] + last[-1].Count[2]);
    weighted.resize(static_cast<std::size_t>(high - low));
    grid.Field = weighted.data();
    grid.FirstIndex = low;
    const double from =
      0.25 * (channel + 1) + progress * static_cast<double>(first - blocks.data());
    completed = this->SumBlocks(
      scene, { first, last }, from, from + progress * static_cast<double>(last - first));
    for (std::int64_t i = low; i < high; ++i)
    {
      const float sum = field->GetValue(i);
      const float mean =
        sum > 0.0f ? std::min(1.0f, static_cast<float>(weighted[i - low] * unit / sum)) : 0.0f;
      blend->SetTypedComponent(i, channel, static_cast<unsigned char>(255.0f * mean + 0.5f));
    }
    first = last;
  }
  return completed;
}

//------------------------------------------------------------------------------
vtkUnsignedCharArray* vtkMetaballField::FindColors(vtkPolyData* packing) const
{
  if (this->ColorArrayName.empty() || packing->GetNumberOfPoints() == 0)
  {
    return nullptr;
  }
  auto* colors = vtkUnsignedCharArray::SafeDownCast(
    packing->GetPointData()->GetAbstractArray(this->ColorArrayName.c_str()));
  if (!colors || colors->GetNumberOfTuples() != packing->GetNumberOfPoints() ||
    colors->GetNumberOfComponents() < 3 || colors->GetNumberOfComponents() > 4)
  {
    throw std::invalid_argument("colors: found no point array '" + this->ColorArrayName +
      "' of three or four unsigned chars a sphere, expected one");
  }
  return colors;
}

//------------------------------------------------------------------------------
void vtkMetaballField::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Kernel: " << this->Kernel << "\n";
  os << indent << "Dimensions: " << Join(this->Dimensions, 3) << "\n";
  os << indent << "Spacing: " << Join(this->Spacing, 3) << "\n";
  os << indent << "ModelBounds: " << Join(this->ModelBounds, 6) << "\n";
  os << indent << "Threshold: " << this->Threshold << "\n";
  os << indent << "Count: " << this->Count << "\n";
  os << indent << "Weights: " << Join(this->Weights.data(), this->GetNumberOfWeights()) << "\n";
  os << indent << "RelativeError: " << this->RelativeError << "\n";
  os << indent << "ComputeGradient: " << (this->ComputeGradient ? "On" : "Off") << "\n";
  os << indent << "ComputeStrongest: " << (this->ComputeStrongest ? "On" : "Off") << "\n";
  os << indent << "ColorArrayName: " << this->ColorArrayName << "\n";
  os << indent << "RadiusArrayName: " << this->RadiusArrayName << "\n";
  os << indent << "ErrorMessage: " << this->ErrorMessage << "\n";
}
