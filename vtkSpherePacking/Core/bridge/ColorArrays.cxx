// SPDX-License-Identifier: BSD-3-Clause
#include "bridge/ColorArrays.h"

#include "vtkDoubleArray.h"
#include "vtkFloatArray.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkUnsignedCharArray.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <string>
#include <vector>

namespace spherepacking
{
namespace
{
using Names = std::vector<std::string>;

// The first array with one of these names, or null.
vtkDoubleArray* Find(vtkPointData* data, const Names& names, bool anyCase = true)
{
  for (int i = 0; i < data->GetNumberOfArrays(); ++i)
  {
    std::string name = data->GetArrayName(i) ? data->GetArrayName(i) : "";
    for (char& c : name)
    {
      c = anyCase && c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c;
    }
    vtkDoubleArray* const array = vtkDoubleArray::FastDownCast(data->GetAbstractArray(i));
    if (std::find(names.begin(), names.end(), name) != names.end() && array &&
      array->GetNumberOfComponents() == 1)
    {
      return array;
    }
  }
  return nullptr;
}

// The parts of one color, or none. An r beside red, green and blue, or beside R, G and B, is a
// radius.
std::vector<vtkDoubleArray*> FindParts(vtkPointData* data)
{
  struct Triple
  {
    std::array<Names, 3> Of;
    bool AnyCase;
  };
  static const std::vector<Triple> triples{ { { { { "red" }, { "green" }, { "blue" } } }, true },
    { { { { "r" }, { "g" }, { "b" } } }, false }, { { { { "R" }, { "G" }, { "B" } } }, false },
    { { { { "r", "red" }, { "g", "green" }, { "b", "blue" } } }, true } };
  for (const Triple& triple : triples)
  {
    std::vector<vtkDoubleArray*> parts;
    for (const Names& names : triple.Of)
    {
      parts.push_back(Find(data, names, triple.AnyCase));
    }
    if (parts[0] && parts[1] && parts[2])
    {
      return parts;
    }
  }
  return {};
}

enum class Range
{
  Fractions,
  Bytes,
  Other
};

Range RangeOf(const std::vector<vtkDoubleArray*>& parts)
{
  bool bytes = true;
  bool fractions = true;
  for (vtkDoubleArray* const part : parts)
  {
    const double* const values = part->GetPointer(0);
    for (vtkIdType i = 0; i < part->GetNumberOfTuples(); ++i)
    {
      bytes &= values[i] >= 0 && values[i] <= 255 && values[i] == std::floor(values[i]);
      fractions &= values[i] >= 0 && values[i] <= 1;
    }
  }
  return fractions ? Range::Fractions : bytes ? Range::Bytes : Range::Other;
}

template <typename ArrayT>
void AddAs(vtkPointData* data, const std::vector<vtkDoubleArray*>& parts)
{
  vtkNew<ArrayT> colors;
  colors->SetName("rgb");
  colors->SetNumberOfComponents(static_cast<int>(parts.size()));
  colors->SetNumberOfTuples(parts[0]->GetNumberOfTuples());
  auto* to = colors->GetPointer(0);
  for (vtkIdType i = 0; i < parts[0]->GetNumberOfTuples(); ++i)
  {
    for (vtkDoubleArray* const part : parts)
    {
      *to++ = static_cast<typename ArrayT::ValueType>(part->GetPointer(0)[i]);
    }
  }
  data->AddArray(colors);
}
}

//------------------------------------------------------------------------------
void AddColors(vtkPointData* data)
{
  std::vector<vtkDoubleArray*> parts = FindParts(data);
  if (parts.empty() || data->HasArray("rgb"))
  {
    return;
  }
  const Range range = RangeOf(parts);
  vtkDoubleArray* const alpha = Find(data, { "a", "alpha" });
  if (alpha && RangeOf({ alpha }) == range)
  {
    parts.push_back(alpha);
  }
  if (range == Range::Fractions)
  {
    AddAs<vtkFloatArray>(data, parts);
  }
  else if (range == Range::Bytes)
  {
    AddAs<vtkUnsignedCharArray>(data, parts);
  }
}
}
