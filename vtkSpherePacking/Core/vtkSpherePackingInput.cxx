// SPDX-License-Identifier: BSD-3-Clause
#include "vtkSpherePackingInput.h"

#include "bridge/RadiusArray.h"

#include "vtkObjectFactory.h"

vtkStandardNewMacro(vtkSpherePackingInput);

//------------------------------------------------------------------------------
vtkDataArray* vtkSpherePackingInput::FindRadii(vtkPolyData* packing, const char* name)
{
  return spherepacking::FindRadii(packing, name, this->Message);
}

//------------------------------------------------------------------------------
void vtkSpherePackingInput::ComputeBounds(
  vtkPolyData* packing, vtkDataArray* radii, double bounds[6])
{
  spherepacking::ComputeBounds(packing, radii, bounds);
}
