// SPDX-License-Identifier: BSD-3-Clause
#include "vtkMetaballField.h"

#include "vtkSpherePackingExtent.h"
#include "vtkSpherePackingFieldBox.h"
#include "vtkSpherePackingFieldInput.h"
#include "vtkSpherePackingFields.h"
#include "vtkSpherePackingInput.h"
#include "vtkSpherePackingMemory.h"
#include "vtkSpherePackingParallelFor.h"
#include "vtkSpherePackingPieces.h"

#include "vtkErrorCode.h"
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
#include <chrono>
#include <cmath>
#include <new>
#include <sstream>
#include <stdexcept>

vtkStandardNewMacro(vtkMetaballField);

using spherepacking::BlobKind;
using spherepacking::FieldBlock;
using spherepacking::FieldScene;

struct vtkMetaballField::Box
{
  double Origin[3];
  double Spacing[3];
  int Dimensions[3];

  double Points() const
  {
    return static_cast<double>(this->Dimensions[0]) * this->Dimensions[1] * this->Dimensions[2];
  }
};

struct vtkMetaballField::BoxKept
{
  Box Grid;
  std::vector<vtkMTimeType> Times;
};

namespace
{
using Clock = std::chrono::steady_clock;

double SecondsSince(Clock::time_point start)
{
  return std::chrono::duration<double>(Clock::now() - start).count();
}

template <typename T>
std::string Join(const T* values, int count)
{
  std::ostringstream text;
  for (int i = 0; i < count; ++i)
  {
    text << (i > 0 ? " " : "") << values[i];
  }
  return text.str();
}

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
  : Kept(new BoxKept)
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
    this->Weights.resize(size, 1.0);
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
int vtkMetaballField::Fail(const std::string& message)
{
  this->ErrorMessage = message;
  this->SetErrorCode(vtkErrorCode::UserError);
  vtkErrorMacro(<< message);
  return 0;
}

//------------------------------------------------------------------------------
void vtkMetaballField::Check() const
{
  const auto refuse = [](const std::string& found, const char* expected)
  { throw std::invalid_argument(found + ", expected " + expected); };
  if (std::any_of(this->Dimensions, this->Dimensions + 3, [](int n) { return n < 1; }))
  {
    refuse("dimensions: found " + Join(this->Dimensions, 3), "three numbers from 1 on");
  }
  const bool none =
    !(this->Spacing[0] != 0.0 || this->Spacing[1] != 0.0 || this->Spacing[2] != 0.0);
  for (const double spacing : this->Spacing)
  {
    if (!none && !(spacing > 0.0 && std::isfinite(spacing)))
    {
      refuse("spacing: found " + Join(this->Spacing, 3), "three numbers above 0");
    }
  }
  const double* bounds = this->ModelBounds;
  for (int axis = 0; axis < 3 && !(bounds[0] > bounds[1]); ++axis)
  {
    if (!std::isfinite(bounds[2 * axis + 1] - bounds[2 * axis]) ||
      bounds[2 * axis] > bounds[2 * axis + 1])
    {
      refuse("bounds: found " + Join(bounds, 6), "x min, x max, y min, y max, z min and z max");
    }
  }
  if (!(this->Threshold >= 0.0 && std::isfinite(this->Threshold)))
  {
    refuse("threshold: found " + Join(&this->Threshold, 1), "a number above 0");
  }
  if (this->Count < 0)
  {
    refuse("count: found " + std::to_string(this->Count), "0 or more");
  }
  for (const double weight : this->Weights)
  {
    if (!(weight >= 0.0 && weight <= 1e20))
    {
      refuse("weights: found " + Join(this->Weights.data(), this->GetNumberOfWeights()),
        "numbers from 0 to 1e20");
    }
  }
  const double error = this->RelativeError;
  if (!(error == 0.0 || (error >= 2e-5 && error <= 0.5)))
  {
    refuse("relative_error: found " + Join(&error, 1), "a number from 2e-5 to 0.5, or 0");
  }
}

//------------------------------------------------------------------------------
vtkMetaballField::Box vtkMetaballField::FindBox(const vtkSpherePackingFieldInput& input) const
{
  double bounds[6] = { -0.5, 0.5, -0.5, 0.5, -0.5, 0.5 };
  const int most = *std::max_element(this->Dimensions, this->Dimensions + 3);
  if (!(this->ModelBounds[0] > this->ModelBounds[1]))
  {
    std::copy_n(this->ModelBounds, 6, bounds);
  }
  else if (!input.Empty() &&
    !(this->Threshold > 0.0 &&
      vtkSpherePackingEncloseSurface(
        input, static_cast<BlobKind>(this->Kernel), this->Threshold, std::min(most, 512), bounds)))
  {
    double length = 0.0;
    for (int axis = 0; axis < 3; ++axis)
    {
      length = std::max(length, input.Bounds[2 * axis + 1] - input.Bounds[2 * axis]);
    }
    for (int side = 0; side < 6; ++side)
    {
      const double room = 0.1 * (length > 0.0 ? length : 1.0);
      bounds[side] = input.Bounds[side] + (side % 2 ? room : -room);
    }
  }
  try
  {
    vtkSpherePackingCheckExtent(bounds);
  }
  catch (const std::invalid_argument&)
  {
    const bool given = !(this->ModelBounds[0] > this->ModelBounds[1]);
    throw std::invalid_argument(given
        ? "bounds: found " + Join(bounds, 6) + ", expected coordinates up to 1e30"
        : "threshold: found " + Join(&this->Threshold, 1) +
          ", whose surface lies beyond coordinates of 1e30, expected a larger one");
  }
  Box box;
  for (int axis = 0; axis < 3; ++axis)
  {
    const double length = bounds[2 * axis + 1] - bounds[2 * axis];
    box.Origin[axis] = bounds[2 * axis];
    box.Dimensions[axis] = this->Dimensions[axis];
    box.Spacing[axis] = box.Dimensions[axis] > 1 ? length / (box.Dimensions[axis] - 1) : 0.0;
    if (this->Spacing[0] > 0.0)
    {
      // Rounding makes no further point.
      const double steps = std::ceil(length / this->Spacing[axis] * (1.0 - 1e-12));
      box.Spacing[axis] = this->Spacing[axis];
      box.Dimensions[axis] = static_cast<int>(std::min(steps, 1e9)) + 1;
      continue;
    }
    if (box.Dimensions[axis] == 1)
    {
      // A single point lies in the middle.
      box.Spacing[axis] = 1.0;
      box.Origin[axis] += 0.5 * length;
    }
    else if (!(box.Spacing[axis] > 0.0))
    {
      throw std::invalid_argument("bounds: found " + Join(bounds, 6) +
        ", expected a length above 0 along axes with more than one point");
    }
  }
  this->CheckSize(box);
  return box;
}

//------------------------------------------------------------------------------
void vtkMetaballField::CheckSize(const Box& box) const
{
  const double bytes = 4.0 + 12.0 * this->ComputeGradient + 8.0 * this->ComputeStrongest +
    7.0 * !this->ColorArrayName.empty();
  if (box.Points() * bytes > vtkSpherePackingHalfOfMemory())
  {
    const bool spaced = this->Spacing[0] > 0.0;
    throw std::invalid_argument(std::string(spaced ? "spacing" : "dimensions") + ": found " +
      (spaced ? Join(this->Spacing, 3) : Join(this->Dimensions, 3)) + ", which makes " +
      Join(box.Dimensions, 3) + " points, more than fit in half of the memory, expected fewer");
  }
}

//------------------------------------------------------------------------------
int vtkMetaballField::RequestInformation(
  vtkInformation*, vtkInformationVector**, vtkInformationVector* outputs)
{
  // Where the grid lies depends on the packing; filters that follow ask before there is data.
  Box box{ {}, { 1.0, 1.0, 1.0 }, { 1, 1, 1 } };
  try
  {
    this->Check();
    this->GetInputAlgorithm()->Update();
    vtkPolyData* packing = vtkPolyData::SafeDownCast(this->GetInput());
    vtkNew<vtkSpherePackingInput> check;
    vtkDataArray* radii = check->FindRadii(packing, this->RadiusArrayName.c_str());
    if (!*check->GetMessage())
    {
      box = this->BoxOf(packing, radii);
    }
  }
  catch (const std::invalid_argument&)
  {
    // RequestData says so.
    box.Dimensions[0] = 1;
  }
  vtkInformation* info = outputs->GetInformationObject(0);
  const int extent[6] = { 0, box.Dimensions[0] - 1, 0, box.Dimensions[1] - 1, 0,
    box.Dimensions[2] - 1 };
  info->Set(vtkStreamingDemandDrivenPipeline::WHOLE_EXTENT(), extent, 6);
  info->Set(vtkDataObject::ORIGIN(), box.Origin, 3);
  info->Set(vtkDataObject::SPACING(), box.Spacing, 3);
  vtkDataObject::SetPointDataActiveScalarInfo(info, VTK_FLOAT, 1);
  return 1;
}

//------------------------------------------------------------------------------
const vtkMetaballField::Box& vtkMetaballField::BoxOf(vtkPolyData* packing, vtkDataArray* radii)
{
  const std::vector<vtkMTimeType> times{ this->GetMTime(), packing->GetMTime(),
    radii ? radii->GetMTime() : 0,
    packing->GetPoints() ? packing->GetPoints()->GetData()->GetMTime() : 0 };
  if (this->Kept->Times != times)
  {
    this->Kept->Times.clear();
    const vtkSpherePackingFieldInput input(packing, radii, this->Count, this->Weights);
    if (!input.Empty())
    {
      vtkSpherePackingCheckExtent(input.Bounds);
    }
    this->Kept->Grid = this->FindBox(input);
    this->Kept->Times = times;
  }
  return this->Kept->Grid;
}

//------------------------------------------------------------------------------
int vtkMetaballField::RequestData(
  vtkInformation*, vtkInformationVector** inputs, vtkInformationVector* outputs)
{
  this->ErrorMessage.clear();
  this->SetErrorCode(vtkErrorCode::NoError);
  vtkImageData* output = vtkImageData::GetData(outputs);
  try
  {
    this->Check();
    vtkPolyData* packing = vtkPolyData::GetData(inputs[0]);
    vtkNew<vtkSpherePackingInput> check;
    vtkDataArray* radii = check->FindRadii(packing, this->RadiusArrayName.c_str());
    if (*check->GetMessage())
    {
      throw std::invalid_argument(check->GetMessage());
    }
    if (packing->GetNumberOfPoints() > VTK_INT_MAX)
    {
      throw std::invalid_argument("packing: found " + std::to_string(packing->GetNumberOfPoints()) +
        " spheres, expected at most 2147483647");
    }
    const vtkSpherePackingFieldInput input(packing, radii, this->Count, this->Weights);
    vtkUnsignedCharArray* colors = this->FindColors(packing);
    const Box box = this->BoxOf(packing, radii);
    output->SetDimensions(box.Dimensions);
    output->SetOrigin(box.Origin);
    output->SetSpacing(box.Spacing);
    this->Make(input, box, colors, output);
    // The executive would throw away what is done.
    this->SetAbortOutput(false);
  }
  catch (const std::invalid_argument& error)
  {
    output->Initialize();
    return this->Fail(error.what());
  }
  catch (const std::bad_alloc&)
  {
    output->Initialize();
    return this->Fail("the field does not fit in the memory that is free");
  }
  return 1;
}

//------------------------------------------------------------------------------
FieldScene vtkMetaballField::Prepare(const vtkSpherePackingFieldInput& input, const Box& box,
  const unsigned char* colors, int channel, int components) const
{
  double all[6];
  for (int axis = 0; axis < 3; ++axis)
  {
    const double last = box.Origin[axis] + (box.Dimensions[axis] - 1) * box.Spacing[axis];
    all[2 * axis] =
      input.Empty() ? box.Origin[axis] : std::min(box.Origin[axis], input.Bounds[2 * axis]);
    all[2 * axis + 1] = input.Empty() ? last : std::max(last, input.Bounds[2 * axis + 1]);
  }
  double origin[3];
  double scale;
  vtkSpherePackingScaleOf(all, origin, scale);
  std::vector<spherepacking::Charge> spheres = input.Scaled(origin, scale);
  for (spherepacking::Charge& sphere : spheres)
  {
    sphere.Strength *=
      colors ? colors[static_cast<vtkIdType>(sphere.Id) * components + channel] / 255.0f : 1.0f;
  }
  FieldScene scene = spherepacking::PrepareField(static_cast<BlobKind>(this->Kernel),
    std::move(spheres), this->RelativeError, vtkSpherePackingParallelFor());
  for (int axis = 0; axis < 3; ++axis)
  {
    scene.Grid.Origin[axis] = (box.Origin[axis] - origin[axis]) * scale;
    scene.Grid.Spacing[axis] = box.Spacing[axis] * scale;
    scene.Grid.Dimensions[axis] = box.Dimensions[axis];
  }
  scene.Grid.Scale = scale;
  return scene;
}

//------------------------------------------------------------------------------
bool vtkMetaballField::Run(const FieldScene& scene, double from, double to)
{
  const std::vector<FieldBlock> blocks = spherepacking::CutIntoBlocks(scene.Grid);
  bool stopped = false;
  vtkSpherePackingMakePieces(
    static_cast<std::int64_t>(blocks.size()),
    [&](std::int64_t i)
    {
      spherepacking::SumField(scene, blocks[i]);
      if (scene.Grid.Strongest)
      {
        spherepacking::FindStrongest(scene, blocks[i]);
      }
    },
    [&](std::int64_t, double share)
    {
      this->UpdateProgress(from + (to - from) * share);
      stopped = stopped || this->CheckAbort();
      return stopped;
    });
  return !stopped;
}

//------------------------------------------------------------------------------
void vtkMetaballField::Make(const vtkSpherePackingFieldInput& input, const Box& box,
  vtkUnsignedCharArray* colors, vtkImageData* output)
{
  const Clock::time_point start = Clock::now();
  FieldScene scene = this->Prepare(input, box, nullptr, 0, 0);
  const double build = SecondsSince(start);
  // A blend needs three more fields.
  const double share = colors ? 0.25 : 1.0;
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
  bool go = this->Run(scene, 0.0, share);
  // The spheres were given parts of the largest weight.
  const double unit = input.MostWeight > 0.0 ? input.MostWeight : 1.0;
  MultiplyBy(unit, field);
  if (gradient)
  {
    MultiplyBy(unit * scene.Grid.Scale, gradient);
  }
  if (colors)
  {
    scene = FieldScene();
    auto* blend = AddArray<vtkUnsignedCharArray>(output, "blend", 3);
    std::vector<float> part(static_cast<std::size_t>(output->GetNumberOfPoints()));
    for (int channel = 0; go && channel < 3; ++channel)
    {
      scene =
        this->Prepare(input, box, colors->GetPointer(0), channel, colors->GetNumberOfComponents());
      scene.Grid.Field = part.data();
      go = this->Run(scene, share * (channel + 1), share * (channel + 2));
      for (vtkIdType i = 0; i < output->GetNumberOfPoints(); ++i)
      {
        const float whole = field->GetValue(i);
        const float mean =
          whole > 0.0f ? std::min(1.0f, static_cast<float>(part[i] * unit / whole)) : 0.0f;
        blend->SetTypedComponent(i, channel, static_cast<unsigned char>(255.0f * mean + 0.5f));
      }
    }
  }
  output->GetPointData()->SetActiveScalars("field");
  vtkSpherePackingAddField(output, "build_seconds", { build });
  vtkSpherePackingAddField(output, "sum_seconds", { SecondsSince(start) - build });
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
