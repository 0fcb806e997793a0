// SPDX-License-Identifier: BSD-3-Clause
// What the parts of vtkMetaballField share. Private to the module.
#ifndef vtkMetaballFieldInternals_h
#define vtkMetaballFieldInternals_h

#include "vtkMetaballField.h"

#include <sstream>
#include <string>
#include <vector>

struct vtkMetaballField::Box
{
  double Origin[3];
  double Spacing[3];
  int Dimensions[3];

  double Points() const
  {
    return static_cast<double>(this->Dimensions[0]) * this->Dimensions[1] * this->Dimensions[2];
  }
};

struct vtkMetaballField::BoxKept
{
  Box Grid;
  std::vector<vtkMTimeType> Times;
};

template <typename T>
std::string vtkMetaballFieldJoin(const T* values, int count)
{
  std::ostringstream text;
  for (int i = 0; i < count; ++i)
  {
    text << (i > 0 ? " " : "") << values[i];
  }
  return text.str();
}

#endif
