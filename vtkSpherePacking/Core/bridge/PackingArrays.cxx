// SPDX-License-Identifier: BSD-3-Clause
#include "bridge/PackingArrays.h"

#include "base/HugePages.h"
#include "bridge/ColorArrays.h"
#include "bridge/FieldData.h"
#include "bridge/NewArrays.h"
#include "bridge/VectorArrays.h"

#include "vtkCellArray.h"
#include "vtkDoubleArray.h"
#include "vtkFieldData.h"
#include "vtkFloatArray.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkSMPTools.h"
#include "vtkStringArray.h"
#include "vtkTypeInt32Array.h"
#include "vtkTypeInt64Array.h"
#include "vtkUnsignedCharArray.h"

#include <algorithm>
#include <limits>
#include <numeric>

namespace spherepacking
{
namespace
{
vtkSmartPointer<vtkDataArray> NewArray(
  bool single, const char* name, int components, vtkIdType count)
{
  vtkSmartPointer<vtkDataArray> array;
  if (single)
  {
    array = vtkSmartPointer<vtkFloatArray>::New();
  }
  else
  {
    array = vtkSmartPointer<vtkDoubleArray>::New();
  }
  array->SetName(name);
  array->SetNumberOfComponents(components);
  array->SetNumberOfTuples(count);
  AdviseHugePages(array->GetVoidPointer(0), array->GetDataTypeSize() * array->GetNumberOfValues());
  return array;
}

// The offsets are implied, so a vertex costs one index of 4 bytes (8 beyond 2^31 spheres) rather
// than the 16 bytes of vtkCellArray's default storage.
template <typename IndexArrayT>
void SetVertices(vtkCellArray* vertices, vtkIdType count)
{
  using ValueT = typename IndexArrayT::ValueType;
  vtkNew<IndexArrayT> indices;
  indices->SetNumberOfValues(count);
  ValueT* values = indices->GetPointer(0);
  vtkSMPTools::For(0, count, vtkSMPTools::THRESHOLD, [values](vtkIdType first, vtkIdType last)
    { std::iota(values + first, values + last, static_cast<ValueT>(first)); });
  vertices->SetData(1, indices);
}

void AddCell(vtkFieldData* data, const SimulationCell& cell)
{
  vtkNew<vtkDoubleArray> vectors;
  vectors->SetName("cell_vectors");
  vectors->SetNumberOfComponents(3);
  vtkNew<vtkDoubleArray> origin;
  origin->SetName("cell_origin");
  vtkNew<vtkUnsignedCharArray> periodic;
  periodic->SetName("cell_periodic");
  for (int i = 0; i < 3; ++i)
  {
    vectors->InsertNextTuple(cell.Vectors[i]);
    origin->InsertNextValue(cell.Origin[i]);
    periodic->InsertNextValue(cell.Periodic[i]);
  }
  data->AddArray(vectors);
  data->AddArray(origin);
  data->AddArray(periodic);
}
}

//------------------------------------------------------------------------------
PackingArrays::PackingArrays(vtkIdType count, bool single, bool hasRadii)
  : Count(count)
  , Single(single)
  , RadiusName(hasRadii ? "radius" : "")
  , CenterArray(NewArray(single, "Points", 3, count))
  , RadiusArray(hasRadii ? NewArray(single, "radius", 1, count) : nullptr)
{
}

//------------------------------------------------------------------------------
double* PackingArrays::AddExtra(const std::string& name)
{
  this->Extras.push_back(NewArray(false, name.c_str(), 1, this->Count));
  return vtkDoubleArray::FastDownCast(this->Extras.back())->GetPointer(0);
}

//------------------------------------------------------------------------------
const double* PackingArrays::FindExtra(const std::string& name) const
{
  const auto found = std::find_if(this->Extras.begin(), this->Extras.end(),
    [&name](vtkAbstractArray* array) { return array->GetName() == name; });
  vtkDoubleArray* const array =
    found == this->Extras.end() ? nullptr : vtkDoubleArray::FastDownCast(*found);
  return array ? array->GetPointer(0) : nullptr;
}

//------------------------------------------------------------------------------
void PackingArrays::RemoveExtra(const std::string& name)
{
  const auto found = std::find_if(this->Extras.begin(), this->Extras.end(),
    [&name](vtkAbstractArray* array) { return array->GetName() == name; });
  this->Extras.erase(found);
}

//------------------------------------------------------------------------------
std::string* PackingArrays::AddText(const std::string& name)
{
  const auto array = vtkSmartPointer<vtkStringArray>::New();
  array->SetName(name.c_str());
  array->SetNumberOfValues(this->Count);
  this->Extras.push_back(array);
  return array->GetPointer(0);
}

//------------------------------------------------------------------------------
void PackingArrays::RemoveText(const std::string* values)
{
  const auto found = std::find_if(this->Extras.begin(), this->Extras.end(),
    [values](vtkAbstractArray* array) { return array->GetVoidPointer(0) == values; });
  this->Extras.erase(found);
}

//------------------------------------------------------------------------------
void PackingArrays::MoveTo(vtkPolyData* output)
{
  vtkNew<vtkPoints> points;
  points->SetData(this->CenterArray);
  output->SetPoints(points);

  // PyVista makes a vertex for every point of a PolyData, and its plots and filters go by cells:
  // without them n_cells is 0, add_mesh draws nothing and threshold returns nothing.
  vtkNew<vtkCellArray> vertices;
  if (this->Count <= std::numeric_limits<vtkTypeInt32>::max())
  {
    SetVertices<vtkTypeInt32Array>(vertices, this->Count);
  }
  else
  {
    SetVertices<vtkTypeInt64Array>(vertices, this->Count);
  }
  output->SetVerts(vertices);

  vtkPointData* data = output->GetPointData();
  data->SetScalars(this->RadiusArray);
  AddNewArrays(data, this->Extras);
  AddVectors(data);
  AddColors(data);
  if (this->Cell)
  {
    AddCell(output->GetFieldData(), *this->Cell);
  }
  if (this->Time)
  {
    AddFieldArray(output, "TimeValue", { *this->Time });
  }
  for (const auto& [name, value] : this->Fields)
  {
    AddFieldArray(output, name.c_str(), { value });
  }
}
}
