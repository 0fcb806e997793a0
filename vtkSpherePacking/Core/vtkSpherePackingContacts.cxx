// SPDX-License-Identifier: BSD-3-Clause
#include "vtkSpherePackingContacts.h"

#include "bridge/ContactOutput.h"
#include "bridge/CoordinateRange.h"
#include "bridge/Guard.h"
#include "bridge/Limits.h"
#include "bridge/MemoryLimit.h"
#include "bridge/PackingCell.h"
#include "bridge/PackingSpheres.h"
#include "bridge/RadiusArray.h"
#include "bridge/RunInterruptibly.h"
#include "bridge/SmpParallelFor.h"
#include "contacts/FindContacts.h"

#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkObjectFactory.h"
#include "vtkPolyData.h"

#include <algorithm>
#include <cmath>

vtkStandardNewMacro(vtkSpherePackingContacts);

using namespace spherepacking;

namespace
{
const auto OutOfMemory = []
{ return std::string("gap: the contacts do not fit in the memory that is free, expected fewer"); };
}

//------------------------------------------------------------------------------
int vtkSpherePackingContacts::RequestData(
  vtkInformation*, vtkInformationVector** inputs, vtkInformationVector* outputs)
{
  vtkPolyData* output = vtkPolyData::GetData(outputs);
  vtkPolyData* packing = vtkPolyData::GetData(inputs[0]);
  const auto work = [&]
  {
    RunInterruptibly(this, packing->GetNumberOfPoints(),
      [&](std::atomic<double>& done) { this->Find(packing, output, done); });
  };
  const Outcome outcome = RunGuarded(this, this->ErrorMessage, OutOfMemory, work);
  if (outcome != Outcome::Done)
  {
    output->Initialize();
  }
  return outcome == Outcome::Failed ? 0 : 1;
}

//------------------------------------------------------------------------------
void vtkSpherePackingContacts::Find(
  vtkPolyData* packing, vtkPolyData* output, std::atomic<double>& done)
{
  if (!(std::abs(this->Gap) <= MaxCoordinate))
  {
    Refuse("gap", this->Gap, "a finite number");
  }
  vtkDataArray* radii = RadiiOf(packing, this->RadiusArrayName);
  CheckCount(packing->GetNumberOfPoints());
  double bounds[6];
  ComputeBounds(packing, radii, bounds);
  if (radii)
  {
    CheckCoordinateRange(bounds);
  }
  const std::optional<SimulationCell> cell = FindCell(packing);
  const PeriodicImages images =
    cell ? PeriodicImages(cell->Origin, cell->Vectors, cell->Periodic) : PeriodicImages();
  const PackingSpheres spheres(packing, radii);
  ContactWork work;
  work.For = SmpParallelFor();
  work.Most = std::floor(HalfOfMemory() / BytesPerContact);
  work.Search = [&](std::int64_t count, const std::function<void(std::int64_t)>& one)
  {
    std::atomic<std::int64_t> number{ 0 };
    work.For(count,
      [&](std::int64_t i)
      {
        one(i);
        done = static_cast<double>(++number) / static_cast<double>(count);
      });
  };
  const HugeArray<Contact> contacts = FindContacts(spheres.Get(), this->Gap, images, work);
  WriteContacts(contacts, spheres.Get(), images, work.For, packing, output);
}

//------------------------------------------------------------------------------
void vtkSpherePackingContacts::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Gap: " << this->Gap << "\n";
  os << indent << "RadiusArrayName: " << this->RadiusArrayName << "\n";
  os << indent << "ErrorMessage: " << this->ErrorMessage << "\n";
}
