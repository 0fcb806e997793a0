// SPDX-License-Identifier: BSD-3-Clause
#include "vtkSpherePackingGrid.h"

#include "bridge/PackingSpheres.h"
#include "bridge/BoxOutput.h"
#include "bridge/FieldData.h"
#include "bridge/MemoryLimit.h"
#include "bridge/SmpParallelFor.h"

#include "accel/GridTable.h"

#include "vtkObjectFactory.h"
#include "vtkPolyData.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>

vtkStandardNewMacro(vtkSpherePackingGrid);

namespace
{
std::int64_t CountTouched(const std::atomic<std::int32_t>* counts, std::int64_t cells)
{
  return std::count_if(
    counts, counts + cells, [](const std::atomic<std::int32_t>& count) { return count != 0; });
}
}

//------------------------------------------------------------------------------
void vtkSpherePackingGrid::CheckOptions(vtkIdType)
{
  const std::string found = "cuts: found " + std::to_string(this->Cuts);
  if (this->Cuts < 0)
  {
    throw std::invalid_argument(found + ", expected 0 or more");
  }
  if (std::pow(this->Cuts + 1.0, 3.0) * sizeof(int) > spherepacking::HalfOfMemory())
  {
    throw std::invalid_argument(
      found + ", which makes more cells than fit in half of the memory, expected fewer");
  }
}

//------------------------------------------------------------------------------
void vtkSpherePackingGrid::MakeBoxes(vtkPolyData* packing, vtkDataArray* radii,
  const double bounds[6], spherepacking::BoxOutput& boxes, vtkPolyData* output)
{
  const spherepacking::Grid grid{
    { { bounds[0], bounds[2], bounds[4] }, { bounds[1], bounds[3], bounds[5] } }, this->Cuts + 1
  };
  double touches = 0.0;
  if (radii)
  {
    const spherepacking::PackingSpheres spheres(packing, radii);
    const spherepacking::CellCounts counts =
      spherepacking::CountTouches(grid, spheres.Get(), 0.0, spherepacking::SmpParallelFor());
    boxes.Reserve(
      "cuts: found " + std::to_string(this->Cuts), CountTouched(counts.get(), grid.Count()));
    for (std::int64_t i = 0; i < grid.Count(); ++i)
    {
      if (const int count = counts[i])
      {
        boxes.Add(grid.CellAt(i), i, 0, count);
        touches += count;
      }
    }
  }
  const double cells = static_cast<double>(grid.Count());
  spherepacking::AddFieldArray(output, "memory_bytes", { 4.0 * touches + 8.0 * (cells + 1.0) });
  spherepacking::AddFieldArray(
    output, "occupied_share", { static_cast<double>(boxes.Boxes.size()) / cells });
}

//------------------------------------------------------------------------------
void vtkSpherePackingGrid::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Cuts: " << this->Cuts << "\n";
}
