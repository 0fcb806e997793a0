// SPDX-License-Identifier: BSD-3-Clause
#ifndef FieldData_h
#define FieldData_h

#include "vtkDataObject.h"
#include "vtkDoubleArray.h"
#include "vtkFieldData.h"
#include "vtkNew.h"

#include <algorithm>
#include <vector>

namespace spherepacking
{
/// Adds a field array of numbers, by which an algorithm tells of its work.
inline void AddFieldArray(
  vtkDataObject* output, const char* name, const std::vector<double>& values)
{
  vtkNew<vtkDoubleArray> array;
  array->SetName(name);
  array->SetNumberOfValues(static_cast<vtkIdType>(values.size()));
  std::copy(values.begin(), values.end(), array->GetPointer(0));
  output->GetFieldData()->AddArray(array);
}
}

#endif
