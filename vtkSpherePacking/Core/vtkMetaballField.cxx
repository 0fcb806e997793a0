// SPDX-License-Identifier: BSD-3-Clause
#include "vtkMetaballFieldInternals.h"

#include "vtkSpherePackingFieldBox.h"
#include "vtkSpherePackingFieldInput.h"
#include "vtkSpherePackingFields.h"
#include "vtkSpherePackingInput.h"
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
#include "vtkPolyData.h"
#include "vtkSMPTools.h"
#include "vtkTypeInt64Array.h"
#include "vtkUnsignedCharArray.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <new>
#include <stdexcept>

vtkStandardNewMacro(vtkMetaballField);

using spherepacking::BlobKind;
using spherepacking::FieldBlock;
using spherepacking::FieldScene;

namespace
{
using Clock = std::chrono::steady_clock;

struct Stopped
{
};

double SecondsSince(Clock::time_point start)
{
  return std::chrono::duration<double>(Clock::now() - start).count();
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
    refuse(
      "dimensions: found " + vtkMetaballFieldJoin(this->Dimensions, 3), "three numbers from 1 on");
  }
  const bool none =
    !(this->Spacing[0] != 0.0 || this->Spacing[1] != 0.0 || this->Spacing[2] != 0.0);
  for (const double spacing : this->Spacing)
  {
    if (!none && !(spacing > 0.0 && std::isfinite(spacing)))
    {
      refuse("spacing: found " + vtkMetaballFieldJoin(this->Spacing, 3), "three numbers above 0");
    }
  }
  const double* bounds = this->ModelBounds;
  for (int axis = 0; axis < 3 && !(bounds[0] > bounds[1]); ++axis)
  {
    if (!std::isfinite(bounds[2 * axis + 1] - bounds[2 * axis]) ||
      bounds[2 * axis] > bounds[2 * axis + 1])
    {
      refuse("bounds: found " + vtkMetaballFieldJoin(bounds, 6),
        "x min, x max, y min, y max, z min and z max");
    }
  }
  if (!(this->Threshold >= 0.0 && std::isfinite(this->Threshold)))
  {
    refuse("threshold: found " + vtkMetaballFieldJoin(&this->Threshold, 1), "a number above 0");
  }
  if (this->Count < 0)
  {
    refuse("count: found " + std::to_string(this->Count), "0 or more");
  }
  for (const double weight : this->Weights)
  {
    if (!(weight >= 0.0 && weight <= 1e20))
    {
      refuse(
        "weights: found " + vtkMetaballFieldJoin(this->Weights.data(), this->GetNumberOfWeights()),
        "numbers from 0 to 1e20");
    }
  }
  const double error = this->RelativeError;
  if (!(error == 0.0 || (error >= 2e-5 && error <= 0.5)))
  {
    refuse("relative_error: found " + vtkMetaballFieldJoin(&error, 1),
      "a number from 2e-5 to 0.5, or 0");
  }
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
    return this->Fail(std::string(this->Spacing[0] > 0.0 ? "spacing" : "dimensions") +
      ": found a field that does not fit in the memory that is free, expected fewer points");
  }
  return 1;
}

//------------------------------------------------------------------------------
FieldScene vtkMetaballField::Prepare(const vtkSpherePackingFieldInput& input, const Box& box,
  const unsigned char* colors, int channel, int components)
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
  spherepacking::FieldGrid grid;
  for (int axis = 0; axis < 3; ++axis)
  {
    grid.Origin[axis] = (box.Origin[axis] - origin[axis]) * scale;
    grid.Spacing[axis] = box.Spacing[axis] * scale;
    grid.Dimensions[axis] = box.Dimensions[axis];
  }
  grid.Scale = scale;
  // The parts of a blend have no gradient.
  const spherepacking::FieldWanted wanted{ !colors && this->ComputeGradient,
    !colors && this->ComputeStrongest };
  const auto stoppable = [&](std::int64_t count, const std::function<void(std::int64_t)>& work)
  {
    this->UpdateProgress(this->GetProgress());
    if (this->CheckAbort())
    {
      throw Stopped();
    }
    vtkSpherePackingParallelFor()(count, work);
  };
  return spherepacking::PrepareField(static_cast<BlobKind>(this->Kernel), std::move(spheres),
    this->RelativeError, grid, wanted, stoppable);
}

//------------------------------------------------------------------------------
bool vtkMetaballField::Run(const FieldScene& scene, Blocks blocks, double from, double to)
{
  Clock::time_point last = Clock::now();
  bool stopped = false;
  vtkSpherePackingMakePieces(
    blocks.Last - blocks.First,
    [&](std::int64_t i)
    {
      spherepacking::SumField(scene, blocks.First[i]);
      if (scene.Grid.Strongest)
      {
        spherepacking::FindStrongest(scene, blocks.First[i]);
      }
    },
    [&](std::int64_t, double share)
    {
      // Observers may take longer than a block.
      if (share >= 1.0 || Clock::now() - last > std::chrono::milliseconds(10))
      {
        this->UpdateProgress(from + (to - from) * share);
        last = Clock::now();
      }
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
  FieldScene scene;
  bool go = true;
  try
  {
    scene = this->Prepare(input, box, nullptr, 0, 0);
  }
  catch (const Stopped&)
  {
    go = false;
  }
  const double build = SecondsSince(start);
  const auto meshes = static_cast<double>(scene.Mesh ? scene.Mesh->Levels.size() : 0);
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
  if (go)
  {
    const std::vector<FieldBlock> blocks = spherepacking::CutIntoBlocks(scene);
    go = this->Run(scene, { blocks.data(), blocks.data() + blocks.size() }, 0.0, share);
  }
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
    for (int channel = 0; go && channel < 3; ++channel)
    {
      go = this->Blend(input, box, colors, channel, field, blend);
    }
  }
  output->GetPointData()->SetActiveScalars("field");
  vtkSpherePackingAddField(output, "meshes", { meshes });
  vtkSpherePackingAddField(output, "build_seconds", { build });
  vtkSpherePackingAddField(output, "sum_seconds", { SecondsSince(start) - build });
}

//------------------------------------------------------------------------------
bool vtkMetaballField::Blend(const vtkSpherePackingFieldInput& input, const Box& box,
  vtkUnsignedCharArray* colors, int channel, vtkFloatArray* field, vtkUnsignedCharArray* blend)
{
  // Enough for all cores; the parts that are not yet mixed are kept for so many alone.
  constexpr std::ptrdiff_t together = 16;
  FieldScene scene;
  try
  {
    scene =
      this->Prepare(input, box, colors->GetPointer(0), channel, colors->GetNumberOfComponents());
  }
  catch (const Stopped&)
  {
    return false;
  }
  const std::vector<FieldBlock> blocks = spherepacking::CutIntoBlocks(scene);
  const double unit = input.MostWeight > 0.0 ? input.MostWeight : 1.0;
  const double share = 0.25 / static_cast<double>(blocks.size());
  const FieldBlock* const end = blocks.data() + blocks.size();
  std::vector<float> part;
  bool go = true;
  for (const FieldBlock* first = blocks.data(); go && first < end;)
  {
    const FieldBlock* last = first;
    while (last < end && (last - first < together || last->First[2] == last[-1].First[2]))
    {
      ++last; // whole layers of blocks
    }
    spherepacking::FieldGrid& grid = scene.Grid;
    grid.FirstPlace = 0;
    const std::int64_t low = grid.Place(0, 0, first->First[2]);
    const std::int64_t high = grid.Place(0, 0, last[-1].First[2] + last[-1].Count[2]);
    part.resize(static_cast<std::size_t>(high - low));
    grid.Field = part.data();
    grid.FirstPlace = low;
    const double from = 0.25 * (channel + 1) + share * static_cast<double>(first - blocks.data());
    go = this->Run(scene, { first, last }, from, from + share * static_cast<double>(last - first));
    for (std::int64_t i = low; i < high; ++i)
    {
      const float whole = field->GetValue(i);
      const float mean =
        whole > 0.0f ? std::min(1.0f, static_cast<float>(part[i - low] * unit / whole)) : 0.0f;
      blend->SetTypedComponent(i, channel, static_cast<unsigned char>(255.0f * mean + 0.5f));
    }
    first = last;
  }
  return go;
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
  os << indent << "Dimensions: " << vtkMetaballFieldJoin(this->Dimensions, 3) << "\n";
  os << indent << "Spacing: " << vtkMetaballFieldJoin(this->Spacing, 3) << "\n";
  os << indent << "ModelBounds: " << vtkMetaballFieldJoin(this->ModelBounds, 6) << "\n";
  os << indent << "Threshold: " << this->Threshold << "\n";
  os << indent << "Count: " << this->Count << "\n";
  os << indent
     << "Weights: " << vtkMetaballFieldJoin(this->Weights.data(), this->GetNumberOfWeights())
     << "\n";
  os << indent << "RelativeError: " << this->RelativeError << "\n";
  os << indent << "ComputeGradient: " << (this->ComputeGradient ? "On" : "Off") << "\n";
  os << indent << "ComputeStrongest: " << (this->ComputeStrongest ? "On" : "Off") << "\n";
  os << indent << "ColorArrayName: " << this->ColorArrayName << "\n";
  os << indent << "RadiusArrayName: " << this->RadiusArrayName << "\n";
  os << indent << "ErrorMessage: " << this->ErrorMessage << "\n";
}
