// SPDX-License-Identifier: BSD-3-Clause
#include "vtkSpherePacker.h"

#include "bridge/FieldData.h"
#include "bridge/Guard.h"
#include "bridge/SmpParallelFor.h"
#include "bridge/SurfaceInput.h"
#include "bridge/UnitFrame.h"
#include "packer/OrientShells.h"
#include "packer/PackSpheres.h"

#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkObjectFactory.h"
#include "vtkPolyData.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <sstream>
#include <stdexcept>

vtkStandardNewMacro(vtkSpherePacker);

using namespace spherepacking;

namespace
{
const auto OutOfMemory = []
{ return std::string("count: not enough memory for so many spheres, expected fewer"); };

double VolumeOf(const std::vector<PackedSphere>& spheres)
{
  double volume = 0.0;
  for (const PackedSphere& sphere : spheres)
  {
    volume += 4.0 / 3.0 * 3.14159265358979323846 * std::pow(sphere.Radius, 3);
  }
  return volume;
}

// Throws if a surface in its unit encloses so little that rounding may have made it.
void CheckVolume(double volume, double unit)
{
  constexpr double least = 1e-12;
  if (!(volume > least))
  {
    std::ostringstream found;
    found << "surface: found a volume of " << volume * unit * unit * unit << " at a size of about "
          << unit << ", expected more than " << least << " times the cube of that: a thicker one";
    throw std::invalid_argument(found.str());
  }
}
}

//------------------------------------------------------------------------------
int vtkSpherePacker::RequestData(
  vtkInformation*, vtkInformationVector** inputs, vtkInformationVector* outputs)
{
  this->Interrupted = false;
  vtkPolyData* output = vtkPolyData::GetData(outputs);
  const auto work = [&] { this->Pack(vtkPolyData::GetData(inputs[0]), output); };
  if (RunGuarded(this, this->ErrorMessage, OutOfMemory, work) == Outcome::Failed)
  {
    output->Initialize();
    return 0;
  }
  return 1;
}

//------------------------------------------------------------------------------
std::function<bool()> vtkSpherePacker::AbortCheck()
{
  return [this, sinceLast = Stopwatch()]() mutable
  {
    // Observers may take longer than what they observe.
    if (sinceLast.Seconds() > 0.05)
    {
      this->UpdateProgress(0.0);
      sinceLast = Stopwatch();
    }
    return this->GetAbortExecute() == 0;
  };
}

//------------------------------------------------------------------------------
void vtkSpherePacker::CheckParameters() const
{
  if (this->NumberOfSpheres < 1)
  {
    Refuse("count", this->NumberOfSpheres, "1 or more");
  }
  if (!(this->MinimumRadius >= 0.0 && std::isfinite(this->MinimumRadius)))
  {
    Refuse("min_radius", this->MinimumRadius, "a finite number from 0 on");
  }
  if (!(this->VolumeFraction > 0.0 && this->VolumeFraction <= 1.0))
  {
    Refuse("fraction", this->VolumeFraction, "a number above 0 and up to 1");
  }
}

//------------------------------------------------------------------------------
void vtkSpherePacker::RefuseForNoSphere() const
{
  if (this->MinimumRadius > 0.0)
  {
    Refuse("min_radius", this->MinimumRadius, "less: no sphere above that was found to fit");
  }
  throw std::invalid_argument("surface: found no sphere of a millionth of its size that fits, "
                              "expected a thicker one");
}

//------------------------------------------------------------------------------
void vtkSpherePacker::Pack(vtkPolyData* surface, vtkPolyData* output)
{
  const Stopwatch watch;
  this->CheckParameters();
  SurfaceMesh mesh = ClosedMeshOf(surface);
  const UnitFrame frame(mesh);
  frame.Normalize(mesh);
  if (!OrientShells(mesh, this->AbortCheck()))
  {
    this->Interrupted = true;
    output->Initialize();
    return;
  }
  const double volume = mesh.Volume();
  const double unitVolume = frame.Unit() * frame.Unit() * frame.Unit();
  CheckVolume(volume, frame.Unit());
  PackingGoal goal;
  goal.Count = this->NumberOfSpheres;
  // UnitFrame::Write() makes spheres smaller by what rounding may do.
  goal.MinimumRadius =
    std::max(this->MinimumRadius / frame.Unit(), 1e-6) + frame.Rounding() / frame.Unit();
  // No limit at 1: of a surface that crosses itself the volume is no measure of what is inside.
  goal.Volume = this->VolumeFraction < 1.0 ? this->VolumeFraction * volume
                                           : std::numeric_limits<double>::infinity();
  goal.Seed = static_cast<std::uint64_t>(static_cast<std::uint32_t>(this->Seed));
  const auto progress = [&](std::int64_t count, double filled)
  {
    const double ofVolume = this->VolumeFraction < 1.0 ? filled / goal.Volume : 0.0;
    this->UpdateProgress(
      std::min(1.0, std::max(static_cast<double>(count) / goal.Count, ofVolume)));
    this->Interrupted = this->GetAbortExecute() != 0;
    return !this->Interrupted;
  };
  const std::vector<PackedSphere> spheres = PackSpheres(mesh, goal, SmpParallelFor(), progress);
  if (spheres.empty() && !this->Interrupted)
  {
    this->RefuseForNoSphere();
  }
  frame.Write(spheres, output);
  const double filled = VolumeOf(spheres) / volume;
  AddFieldArray(output, "surface_volume", { volume * unitVolume });
  AddFieldArray(output, "volume_fraction",
    { filled > 1.0 ? std::numeric_limits<double>::quiet_NaN() : filled });
  AddFieldArray(output, "build_seconds", { watch.Seconds() });
}

//------------------------------------------------------------------------------
void vtkSpherePacker::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "NumberOfSpheres: " << this->NumberOfSpheres << "\n";
  os << indent << "MinimumRadius: " << this->MinimumRadius << "\n";
  os << indent << "VolumeFraction: " << this->VolumeFraction << "\n";
  os << indent << "Seed: " << this->Seed << "\n";
  os << indent << "Interrupted: " << this->Interrupted << "\n";
  os << indent << "ErrorMessage: " << this->ErrorMessage << "\n";
}
