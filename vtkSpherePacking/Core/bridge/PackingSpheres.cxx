// SPDX-License-Identifier: BSD-3-Clause
#include "bridge/PackingSpheres.h"

#include "vtkDataArray.h"
#include "vtkDataArrayRange.h"
#include "vtkDoubleArray.h"
#include "vtkFloatArray.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"

namespace spherepacking
{
namespace
{
// Points one of the pointers at the values, of which `copy` is one if they are of another type.
void Use(
  vtkDataArray* array, const float*& floats, const double*& doubles, std::vector<double>& copy)
{
  if (auto* floatArray = vtkFloatArray::FastDownCast(array))
  {
    floats = floatArray->GetPointer(0);
  }
  else if (auto* doubleArray = vtkDoubleArray::FastDownCast(array))
  {
    doubles = doubleArray->GetPointer(0);
  }
  else
  {
    const auto values = vtk::DataArrayValueRange(array);
    copy.assign(values.begin(), values.end());
    doubles = copy.data();
  }
}
}

//------------------------------------------------------------------------------
PackingSpheres::PackingSpheres(vtkPolyData* packing, vtkDataArray* radii)
{
  if (radii && radii->GetNumberOfTuples() > 0)
  {
    this->Spheres.Count = radii->GetNumberOfTuples();
    Use(packing->GetPoints()->GetData(), this->Spheres.FloatCenters, this->Spheres.DoubleCenters,
      this->Centers);
    Use(radii, this->Spheres.FloatRadii, this->Spheres.DoubleRadii, this->Radii);
  }
}
}
