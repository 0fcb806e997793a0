// SPDX-License-Identifier: BSD-3-Clause
// Where the grid of a vtkMetaballField lies.
#include "vtkMetaballFieldInternals.h"

#include "vtkSpherePackingExtent.h"
#include "vtkSpherePackingFieldBox.h"
#include "vtkSpherePackingFieldInput.h"
#include "vtkSpherePackingInput.h"
#include "vtkSpherePackingMemory.h"

#include "vtkDataArray.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkNew.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkStreamingDemandDrivenPipeline.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>

using spherepacking::BlobKind;

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
        ? "bounds: found " + vtkMetaballFieldJoin(bounds, 6) + ", expected coordinates up to 1e30"
        : "threshold: found " + vtkMetaballFieldJoin(&this->Threshold, 1) +
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
      throw std::invalid_argument("bounds: found " + vtkMetaballFieldJoin(bounds, 6) +
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
  // Images have the coordinates along each axis, and there are three of them on the way.
  const double axes =
    24.0 * (static_cast<double>(box.Dimensions[0]) + box.Dimensions[1] + box.Dimensions[2]);
  if (box.Points() * bytes + axes > vtkSpherePackingHalfOfMemory())
  {
    const bool spaced = this->Spacing[0] > 0.0;
    throw std::invalid_argument(std::string(spaced ? "spacing" : "dimensions") + ": found " +
      (spaced ? vtkMetaballFieldJoin(this->Spacing, 3)
              : vtkMetaballFieldJoin(this->Dimensions, 3)) +
      ", which makes " + vtkMetaballFieldJoin(box.Dimensions, 3) +
      " points, more than fit in half of the memory, expected fewer");
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
