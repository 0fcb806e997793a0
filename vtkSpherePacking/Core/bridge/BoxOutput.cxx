// SPDX-License-Identifier: BSD-3-Clause
#include "bridge/BoxOutput.h"

#include "bridge/MemoryLimit.h"

#include "vtkCellArray.h"
#include "vtkCellData.h"
#include "vtkDoubleArray.h"
#include "vtkIdTypeArray.h"
#include "vtkIntArray.h"
#include "vtkNew.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"

#include <algorithm>
#include <stdexcept>

namespace spherepacking
{
namespace
{
// Corner i is high along x, y, z where bit 0, 1, 2 of i is set.
constexpr int Faces[6][4] = { { 0, 4, 6, 2 }, { 1, 3, 7, 5 }, { 0, 1, 5, 4 }, { 2, 6, 7, 3 },
  { 0, 2, 3, 1 }, { 4, 5, 7, 6 } };
constexpr int Edges[12][2] = { { 0, 1 }, { 2, 3 }, { 4, 5 }, { 6, 7 }, { 0, 2 }, { 1, 3 }, { 4, 6 },
  { 5, 7 }, { 0, 4 }, { 1, 5 }, { 2, 6 }, { 3, 7 } };

template <int Cells, int Corners>
vtkNew<vtkCellArray> MakeCells(vtkIdType boxes, const int (&corners)[Cells][Corners])
{
  vtkNew<vtkIdTypeArray> connectivity;
  connectivity->SetNumberOfValues(boxes * Cells * Corners);
  vtkIdType* at = connectivity->GetPointer(0);
  for (vtkIdType box = 0; box < boxes; ++box)
  {
    for (const auto& cell : corners)
    {
      at = std::transform(cell, cell + Corners, at, [&](int corner) { return 8 * box + corner; });
    }
  }
  vtkNew<vtkCellArray> cells;
  cells->SetData(Corners, connectivity);
  return cells;
}

template <typename ArrayT, typename Value>
void AddCellArray(
  vtkPolyData* output, const char* name, const std::vector<Value>& values, int cellsPerBox)
{
  vtkNew<ArrayT> array;
  array->SetName(name);
  array->SetNumberOfValues(static_cast<vtkIdType>(values.size()) * cellsPerBox);
  Value* at = array->GetPointer(0);
  for (const Value value : values)
  {
    at = std::fill_n(at, cellsPerBox, value);
  }
  output->GetCellData()->AddArray(array);
}
}

//------------------------------------------------------------------------------
void BoxOutput::Reserve(const std::string& asked, vtkIdType count)
{
  if (static_cast<double>(count) * BytesPerBox > HalfOfMemory())
  {
    throw std::invalid_argument(asked + ", which makes " + std::to_string(count) +
      " boxes, more than fit in half of the memory, expected fewer");
  }
  this->Boxes.reserve(count);
  this->Ids.reserve(count);
  this->Depths.reserve(count);
  this->Counts.reserve(count);
}

//------------------------------------------------------------------------------
void BoxOutput::Add(const Box& box, vtkIdType id, int depth, vtkIdType count)
{
  this->Boxes.push_back(box);
  this->Ids.push_back(id);
  this->Depths.push_back(depth);
  this->Counts.push_back(count);
}

//------------------------------------------------------------------------------
void BoxOutput::Write(vtkPolyData* output, bool asLines) const
{
  const vtkIdType count = static_cast<vtkIdType>(this->Boxes.size());
  vtkNew<vtkDoubleArray> coordinates;
  coordinates->SetNumberOfComponents(3);
  coordinates->SetNumberOfTuples(8 * count);
  double* at = coordinates->GetPointer(0);
  for (const Box& box : this->Boxes)
  {
    for (int corner = 0; corner < 8; ++corner)
    {
      for (int axis = 0; axis < 3; ++axis)
      {
        *at++ = (corner >> axis) & 1 ? box.High[axis] : box.Low[axis];
      }
    }
  }
  vtkNew<vtkPoints> points;
  points->SetData(coordinates);
  output->SetPoints(points);
  if (asLines)
  {
    output->SetLines(MakeCells(count, Edges));
  }
  else
  {
    output->SetPolys(MakeCells(count, Faces));
  }
  const int cellsPerBox = asLines ? 12 : 6;
  AddCellArray<vtkIdTypeArray>(output, "box_id", this->Ids, cellsPerBox);
  AddCellArray<vtkIntArray>(output, "depth", this->Depths, cellsPerBox);
  AddCellArray<vtkIdTypeArray>(output, "count", this->Counts, cellsPerBox);
}
}
