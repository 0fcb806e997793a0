// SPDX-License-Identifier: BSD-3-Clause
// What an algorithm says of its work, beside what it made. Private to the module.
#ifndef vtkSpherePackingFields_h
#define vtkSpherePackingFields_h

#include "vtkDataObject.h"
#include "vtkDoubleArray.h"
#include "vtkFieldData.h"
#include "vtkNew.h"

#include <algorithm>
#include <vector>

VTK_ABI_NAMESPACE_BEGIN
inline void vtkSpherePackingAddField(
  vtkDataObject* output, const char* name, const std::vector<double>& values)
{
  vtkNew<vtkDoubleArray> array;
  array->SetName(name);
  array->SetNumberOfValues(static_cast<vtkIdType>(values.size()));
  std::copy(values.begin(), values.end(), array->GetPointer(0));
  output->GetFieldData()->AddArray(array);
}
VTK_ABI_NAMESPACE_END

#endif
