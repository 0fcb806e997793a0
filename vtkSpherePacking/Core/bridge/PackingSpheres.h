// SPDX-License-Identifier: BSD-3-Clause
#ifndef PackingSpheres_h
#define PackingSpheres_h

#include "base/HugeArray.h"
#include "base/ParallelFor.h"
#include "base/SphereArrays.h"

#include <vector>

class vtkDataArray;
class vtkPolyData;

namespace spherepacking
{
/// The spheres of a packing for those who know no VTK. Centres and radii that are floats or doubles
/// side by side are used where they are, which has to outlive this, until Own() copies them; others
/// are copied as doubles.
/// `radii` is what RadiiOf() in bridge/RadiusArray.h found; null gives no spheres.
class PackingSpheres
{
public:
  PackingSpheres(vtkPolyData* packing, vtkDataArray* radii);
  PackingSpheres(const PackingSpheres&) = delete;
  void operator=(const PackingSpheres&) = delete;

  const SphereArrays& Get() const { return this->Spheres; }

  /// Copies what is used where it is, so that writing there makes no difference from now on.
  void Own(const ParallelFor& parallelFor);

private:
  SphereArrays Spheres;
  std::vector<double> Centers; // copies, if needed
  std::vector<double> Radii;
  HugeArray<char> OwnCenters;
  HugeArray<char> OwnRadii;
};
}

#endif
