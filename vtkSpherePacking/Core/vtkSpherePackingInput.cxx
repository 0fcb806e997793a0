// SPDX-License-Identifier: BSD-3-Clause
#include "vtkSpherePackingInput.h"

#include "bridge/RadiusArray.h"

#include "vtkObjectFactory.h"

#include <new>

vtkStandardNewMacro(vtkSpherePackingInput);

//------------------------------------------------------------------------------
vtkDataArray* vtkSpherePackingInput::FindRadii(vtkPolyData* packing, const char* name)
{
  try
  {
    return spherepacking::FindRadii(packing, name, this->Message);
  }
  catch (const std::bad_alloc&)
  {
    this->Message = "out of memory"; // short enough for a std::string to hold it itself
    return nullptr;
  }
}

//------------------------------------------------------------------------------
void vtkSpherePackingInput::ComputeBounds(
  vtkPolyData* packing, vtkDataArray* radii, double bounds[6])
{
  spherepacking::ComputeBounds(packing, radii, bounds);
}
