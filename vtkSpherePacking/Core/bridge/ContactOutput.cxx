// SPDX-License-Identifier: BSD-3-Clause
#include "bridge/ContactOutput.h"

#include "vtkCellArray.h"
#include "vtkCellData.h"
#include "vtkDoubleArray.h"
#include "vtkFieldData.h"
#include "vtkIdList.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkSmartPointer.h"
#include "vtkTypeInt32Array.h"
#include "vtkTypeInt64Array.h"

#include <algorithm>
#include <limits>
#include <numeric>
#include <vector>

namespace spherepacking
{
namespace
{
constexpr std::int64_t Chunk = 1 << 14;

constexpr CellShift None{ 0, 0, 0 };

template <typename ArrayT>
vtkSmartPointer<ArrayT> NewArray(const char* name, int components, vtkIdType count)
{
  const auto array = vtkSmartPointer<ArrayT>::New();
  array->SetName(name);
  array->SetNumberOfComponents(components);
  array->SetNumberOfTuples(count);
  return array;
}

// The contacts that reach across a face of the cell; each gets a point at the image.
std::vector<std::int64_t> AcrossFaces(const HugeArray<Contact>& contacts)
{
  std::vector<std::int64_t> across;
  for (std::size_t k = 0; k < contacts.size(); ++k)
  {
    if (contacts[k].Shift != None)
    {
      across.push_back(static_cast<std::int64_t>(k));
    }
  }
  return across;
}

// The points of the packing, then the images, which have the point data of their spheres.
void SetPoints(const HugeArray<Contact>& contacts, const std::vector<std::int64_t>& across,
  const PeriodicImages& images, vtkPolyData* packing, vtkPolyData* output)
{
  const vtkIdType count = packing->GetNumberOfPoints();
  const vtkIdType extra = static_cast<vtkIdType>(across.size());
  if (extra == 0)
  {
    output->SetPoints(packing->GetPoints());
    output->GetPointData()->PassData(packing->GetPointData());
    return;
  }
  // In double precision, so that a line is as long as its contact says.
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  points->SetNumberOfPoints(count + extra);
  points->GetData()->InsertTuples(0, count, 0, packing->GetPoints()->GetData());
  vtkNew<vtkIdList> from;
  vtkNew<vtkIdList> to;
  from->SetNumberOfIds(count + extra);
  to->SetNumberOfIds(count + extra);
  std::iota(from->begin(), from->end(), 0);
  std::iota(to->begin(), to->end(), 0);
  for (vtkIdType k = 0; k < extra; ++k)
  {
    const Contact& contact = contacts[across[k]];
    double point[3];
    packing->GetPoint(contact.J, point);
    const Vector3 shift = images.Sum(contact.Shift);
    points->SetPoint(count + k, point[0] + shift.X, point[1] + shift.Y, point[2] + shift.Z);
    from->SetId(count + k, contact.J);
  }
  output->SetPoints(points);
  vtkPointData* const data = output->GetPointData();
  data->CopyAllOn();
  data->CopyAllocate(packing->GetPointData(), count + extra);
  data->CopyData(packing->GetPointData(), from, to);
}

// How many contacts each point's sphere has; one with its own image touches it on both sides.
void AddCoordination(const HugeArray<Contact>& contacts, const std::vector<std::int64_t>& across,
  vtkIdType spheres, vtkPolyData* output)
{
  const vtkIdType extra = static_cast<vtkIdType>(across.size());
  const auto coordination = NewArray<vtkTypeInt32Array>("coordination", 1, spheres + extra);
  std::int32_t* const values = coordination->GetPointer(0);
  std::fill(values, values + spheres, 0);
  for (std::size_t k = 0; k < contacts.size(); ++k)
  {
    ++values[contacts[k].I];
    ++values[contacts[k].J];
  }
  for (vtkIdType k = 0; k < extra; ++k)
  {
    values[spheres + k] = values[contacts[across[k]].J];
  }
  output->GetPointData()->AddArray(coordination);
}

template <typename IndexArrayT>
void SetLines(const HugeArray<Contact>& contacts, const std::vector<std::int64_t>& across,
  vtkIdType spheres, vtkPolyData* output)
{
  using ValueT = typename IndexArrayT::ValueType;
  const vtkIdType count = static_cast<vtkIdType>(contacts.size());
  vtkNew<IndexArrayT> ends;
  ends->SetNumberOfValues(2 * count);
  ValueT* const values = ends->GetPointer(0);
  for (vtkIdType k = 0; k < count; ++k)
  {
    values[2 * k] = contacts[k].I;
    values[2 * k + 1] = contacts[k].J;
  }
  for (std::size_t k = 0; k < across.size(); ++k)
  {
    values[2 * across[k] + 1] = static_cast<ValueT>(spheres + static_cast<vtkIdType>(k));
  }
  vtkNew<vtkCellArray> lines;
  lines->SetData(2, ends);
  output->SetLines(lines);
}

void AddCellArrays(const HugeArray<Contact>& contacts, const SphereArrays& spheres,
  const PeriodicImages& images, const ParallelFor& parallelFor, vtkPolyData* output)
{
  const vtkIdType count = static_cast<vtkIdType>(contacts.size());
  const auto gaps = NewArray<vtkDoubleArray>("gap", 1, count);
  const auto overlaps = NewArray<vtkDoubleArray>("overlap", 1, count);
  const auto first = NewArray<vtkTypeInt32Array>("i", 1, count);
  const auto second = NewArray<vtkTypeInt32Array>("j", 1, count);
  const auto shifts = NewArray<vtkTypeInt32Array>("cell_shift", 3, images.Any() ? count : 0);
  parallelFor((count + Chunk - 1) / Chunk,
    [&](std::int64_t chunk)
    {
      const std::int64_t end = std::min<std::int64_t>((chunk + 1) * Chunk, count);
      for (std::int64_t k = chunk * Chunk; k < end; ++k)
      {
        const Contact& contact = contacts[k];
        const double gap = GapOf(spheres, contact.I, contact.J, images.Sum(contact.Shift));
        gaps->SetValue(k, gap);
        overlaps->SetValue(k, std::max(0.0, -gap));
        first->SetValue(k, contact.I);
        second->SetValue(k, contact.J);
        if (images.Any())
        {
          shifts->SetTypedTuple(k, contact.Shift.data());
        }
      }
    });
  vtkCellData* const data = output->GetCellData();
  data->SetScalars(gaps);
  data->AddArray(overlaps);
  data->AddArray(first);
  data->AddArray(second);
  if (images.Any())
  {
    data->AddArray(shifts);
  }
}
}

//------------------------------------------------------------------------------
void WriteContacts(const HugeArray<Contact>& contacts, const SphereArrays& spheres,
  const PeriodicImages& images, const ParallelFor& parallelFor, vtkPolyData* packing,
  vtkPolyData* output)
{
  const std::vector<std::int64_t> across = AcrossFaces(contacts);
  const vtkIdType points = spheres.Count + static_cast<vtkIdType>(across.size());
  SetPoints(contacts, across, images, packing, output);
  AddCoordination(contacts, across, spheres.Count, output);
  if (points <= std::numeric_limits<vtkTypeInt32>::max())
  {
    SetLines<vtkTypeInt32Array>(contacts, across, spheres.Count, output);
  }
  else
  {
    SetLines<vtkTypeInt64Array>(contacts, across, spheres.Count, output);
  }
  AddCellArrays(contacts, spheres, images, parallelFor, output);
  output->GetFieldData()->PassData(packing->GetFieldData());
}
}
