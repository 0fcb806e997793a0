// SPDX-License-Identifier: BSD-3-Clause
#ifndef NewArrays_h
#define NewArrays_h

#include "vtkAbstractArray.h"
#include "vtkPointData.h"
#include "vtkSmartPointer.h"

#include <string>
#include <vector>

namespace spherepacking
{
/// Adds arrays whose names no other has. VTK would compare each name with all others and make room
/// for each by itself, which takes a time that is quadratic in the number of arrays.
inline void AddNewArrays(
  vtkPointData* data, const std::vector<vtkSmartPointer<vtkAbstractArray>>& arrays)
{
  data->AllocateArrays(data->GetNumberOfArrays() + static_cast<int>(arrays.size()));
  for (vtkAbstractArray* const array : arrays)
  {
    const std::string name = array->GetName();
    array->SetName(nullptr); // for which VTK looks at no other
    data->AddArray(array);
    array->SetName(name.c_str());
  }
}
}

#endif
