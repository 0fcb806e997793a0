// SPDX-License-Identifier: BSD-3-Clause
#include "vtkSpherePackingBoxAlgorithm.h"

#include "bridge/BoxOutput.h"
#include "bridge/CoordinateRange.h"
#include "bridge/FieldData.h"
#include "bridge/Guard.h"
#include "bridge/RadiusArray.h"
#include "bridge/RunInterruptibly.h"

#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkPolyData.h"

namespace
{
const auto OutOfMemory = []
{ return std::string("the boxes do not fit in the memory that is free, expected fewer"); };
}

//------------------------------------------------------------------------------
int vtkSpherePackingBoxAlgorithm::RequestData(
  vtkInformation*, vtkInformationVector** inputs, vtkInformationVector* outputs)
{
  using spherepacking::Outcome;
  vtkPolyData* packing = vtkPolyData::GetData(inputs[0]);
  vtkPolyData* output = vtkPolyData::GetData(outputs);
  const auto work = [&](std::atomic<double>&)
  {
    this->CheckOptions(packing->GetNumberOfPoints());
    vtkDataArray* radii = spherepacking::RadiiOf(packing, this->RadiusArrayName);
    const spherepacking::Stopwatch watch;
    double bounds[6];
    spherepacking::ComputeBounds(packing, radii, bounds);
    spherepacking::CheckFinite(bounds);
    spherepacking::BoxOutput boxes;
    this->MakeBoxes(packing, radii, bounds, boxes, output);
    spherepacking::AddFieldArray(output, "build_seconds", { watch.Seconds() });
    boxes.Write(output, this->BoxesAsLines);
  };
  const Outcome outcome = spherepacking::RunGuarded(this, this->ErrorMessage, OutOfMemory,
    [&] { spherepacking::RunInterruptibly(this, packing->GetNumberOfPoints(), work); });
  return outcome == Outcome::Failed ? 0 : 1;
}

//------------------------------------------------------------------------------
void vtkSpherePackingBoxAlgorithm::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "BoxesAsLines: " << this->BoxesAsLines << "\n";
  os << indent << "RadiusArrayName: " << this->RadiusArrayName << "\n";
  os << indent << "ErrorMessage: " << this->ErrorMessage << "\n";
}
