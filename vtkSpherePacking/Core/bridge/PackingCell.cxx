// SPDX-License-Identifier: BSD-3-Clause
#include "bridge/PackingCell.h"

#include "bridge/Guard.h"

#include "vtkDataArray.h"
#include "vtkFieldData.h"
#include "vtkPolyData.h"

#include <cmath>

namespace spherepacking
{
namespace
{
// The values of a field array, or nothing where there is none.
template <int Count>
std::optional<std::array<double, Count>> FieldValues(vtkPolyData* packing, const char* name)
{
  vtkDataArray* const array = packing->GetFieldData()->GetArray(name);
  if (!array)
  {
    return std::nullopt;
  }
  if (array->GetNumberOfValues() != Count)
  {
    Refuse(name, std::to_string(array->GetNumberOfValues()) + " values",
      std::to_string(Count) + " numbers");
  }
  std::array<double, Count> values;
  const int components = array->GetNumberOfComponents();
  for (int i = 0; i < Count; ++i)
  {
    values[i] = array->GetComponent(i / components, i % components);
    if (!std::isfinite(values[i]))
    {
      Refuse(name, values[i], "finite numbers");
    }
  }
  return values;
}
}

//------------------------------------------------------------------------------
std::optional<SimulationCell> FindCell(vtkPolyData* packing)
{
  const auto vectors = FieldValues<9>(packing, "cell_vectors");
  if (!vectors)
  {
    return std::nullopt;
  }
  const auto origin = FieldValues<3>(packing, "cell_origin");
  const auto periodic = FieldValues<3>(packing, "cell_periodic");
  SimulationCell cell;
  for (int i = 0; i < 3; ++i)
  {
    cell.Origin[i] = origin ? (*origin)[i] : 0.0;
    cell.Periodic[i] = !periodic || (*periodic)[i] != 0.0;
    for (int k = 0; k < 3; ++k)
    {
      cell.Vectors[i][k] = (*vectors)[3 * i + k];
    }
  }
  return cell;
}
}
