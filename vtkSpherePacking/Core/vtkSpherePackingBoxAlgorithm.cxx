// SPDX-License-Identifier: BSD-3-Clause
#include "vtkSpherePackingBoxAlgorithm.h"

#include "vtkSpherePackingBoxes.h"
#include "vtkSpherePackingExtent.h"
#include "vtkSpherePackingFields.h"
#include "vtkSpherePackingInput.h"

#include "vtkErrorCode.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkNew.h"
#include "vtkPolyData.h"

#include <chrono>
#include <new>
#include <stdexcept>

namespace
{
vtkDataArray* RadiiOf(vtkPolyData* packing, const char* name)
{
  vtkNew<vtkSpherePackingInput> check;
  vtkDataArray* radii = check->FindRadii(packing, name);
  if (*check->GetMessage())
  {
    throw std::invalid_argument(check->GetMessage());
  }
  return radii;
}
}

//------------------------------------------------------------------------------
int vtkSpherePackingBoxAlgorithm::RequestData(
  vtkInformation*, vtkInformationVector** inputs, vtkInformationVector* outputs)
{
  this->ErrorMessage.clear();
  this->SetErrorCode(vtkErrorCode::NoError);
  vtkPolyData* packing = vtkPolyData::GetData(inputs[0]);
  vtkPolyData* output = vtkPolyData::GetData(outputs);
  try
  {
    this->CheckOptions(packing->GetNumberOfPoints());
    vtkDataArray* radii = RadiiOf(packing, this->RadiusArrayName.c_str());
    const auto start = std::chrono::steady_clock::now();
    double bounds[6];
    vtkSpherePackingInput::ComputeBounds(packing, radii, bounds);
    vtkSpherePackingCheckFinite(bounds);
    vtkSpherePackingBoxes boxes;
    this->MakeBoxes(packing, radii, bounds, boxes, output);
    const std::chrono::duration<double> seconds = std::chrono::steady_clock::now() - start;
    vtkSpherePackingAddField(output, "build_seconds", { seconds.count() });
    boxes.Write(output, this->BoxesAsLines);
  }
  catch (const std::invalid_argument& error)
  {
    return this->Fail(error.what());
  }
  catch (const std::bad_alloc&)
  {
    return this->Fail("the boxes do not fit in the memory that is free, expected fewer");
  }
  return 1;
}

//------------------------------------------------------------------------------
int vtkSpherePackingBoxAlgorithm::Fail(const std::string& message)
{
  this->ErrorMessage = message;
  this->SetErrorCode(vtkErrorCode::UserError);
  vtkErrorMacro(<< message);
  return 0;
}

//------------------------------------------------------------------------------
void vtkSpherePackingBoxAlgorithm::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "BoxesAsLines: " << this->BoxesAsLines << "\n";
  os << indent << "RadiusArrayName: " << this->RadiusArrayName << "\n";
  os << indent << "ErrorMessage: " << this->ErrorMessage << "\n";
}
