// SPDX-License-Identifier: BSD-3-Clause
#include "vtkSpherePackingGrid.h"

#include "vtkSpherePackingBoxes.h"
#include "vtkSpherePackingInput.h"
#include "vtkSpherePackingMemory.h"
#include "vtkSpherePackingSpheres.h"

#include "kernels/Grid.h"

#include "vtkDoubleArray.h"
#include "vtkErrorCode.h"
#include "vtkFieldData.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkPolyData.h"
#include "vtkSMPTools.h"

#include <atomic>
#include <chrono>
#include <cmath>
#include <memory>

vtkStandardNewMacro(vtkSpherePackingGrid);

namespace
{
using Counts = std::unique_ptr<std::atomic<int>[]>;

Counts CountSpheres(
  const spherepacking::Grid& grid, const std::vector<spherepacking::Sphere>& spheres)
{
  Counts counts(new std::atomic<int>[grid.Count()]());
  vtkSMPTools::For(0, static_cast<vtkIdType>(spheres.size()),
    [&](vtkIdType begin, vtkIdType end)
    {
      for (vtkIdType i = begin; i < end; ++i)
      {
        grid.ForEachTouched(spheres[i],
          [&](std::int64_t cell) { counts[cell].fetch_add(1, std::memory_order_relaxed); });
      }
    });
  return counts;
}

void AddFieldValue(vtkPolyData* output, const char* name, double value)
{
  vtkNew<vtkDoubleArray> array;
  array->SetName(name);
  array->InsertNextValue(value);
  output->GetFieldData()->AddArray(array);
}
}

//------------------------------------------------------------------------------
int vtkSpherePackingGrid::Fail(const std::string& message)
{
  this->ErrorMessage = message;
  this->SetErrorCode(vtkErrorCode::UserError);
  vtkErrorMacro(<< message);
  return 0;
}

//------------------------------------------------------------------------------
int vtkSpherePackingGrid::RequestData(
  vtkInformation*, vtkInformationVector** inputs, vtkInformationVector* outputs)
{
  this->ErrorMessage.clear();
  this->SetErrorCode(vtkErrorCode::NoError);
  vtkPolyData* packing = vtkPolyData::GetData(inputs[0]);
  vtkPolyData* output = vtkPolyData::GetData(outputs);
  if (this->Cuts < 0)
  {
    return this->Fail("cuts: found " + std::to_string(this->Cuts) + ", expected 0 or more");
  }
  const double cells = std::pow(this->Cuts + 1.0, 3.0);
  if (cells * sizeof(int) > vtkSpherePackingHalfOfMemory())
  {
    return this->Fail("cuts: found " + std::to_string(this->Cuts) +
      ", which makes more cells than fit in half of the memory, expected fewer");
  }
  vtkNew<vtkSpherePackingInput> check;
  vtkDataArray* radii = check->FindRadii(packing, this->RadiusArrayName.c_str());
  if (*check->GetMessage())
  {
    return this->Fail(check->GetMessage());
  }

  const auto start = std::chrono::steady_clock::now();
  vtkSpherePackingBoxes boxes;
  double touches = 0.0;
  if (radii)
  {
    double bounds[6];
    vtkSpherePackingInput::ComputeBounds(packing, radii, bounds);
    const spherepacking::Grid grid{
      { { bounds[0], bounds[2], bounds[4] }, { bounds[1], bounds[3], bounds[5] } }, this->Cuts + 1
    };
    const Counts counts = CountSpheres(grid, vtkSpherePackingSpheresOf(packing, radii));
    for (std::int64_t i = 0; i < grid.Count(); ++i)
    {
      if (const int count = counts[i])
      {
        boxes.Add(grid.CellAt(i), i, 0, count);
        touches += count;
      }
    }
  }
  const std::chrono::duration<double> seconds = std::chrono::steady_clock::now() - start;
  boxes.Write(output, this->BoxesAsLines);
  AddFieldValue(output, "build_seconds", seconds.count());
  AddFieldValue(output, "memory_bytes", 4.0 * touches + 8.0 * (cells + 1.0));
  AddFieldValue(output, "occupied_share", static_cast<double>(boxes.Boxes.size()) / cells);
  return 1;
}

//------------------------------------------------------------------------------
void vtkSpherePackingGrid::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Cuts: " << this->Cuts << "\n";
  os << indent << "BoxesAsLines: " << this->BoxesAsLines << "\n";
  os << indent << "RadiusArrayName: " << this->RadiusArrayName << "\n";
  os << indent << "ErrorMessage: " << this->ErrorMessage << "\n";
}
