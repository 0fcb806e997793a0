// SPDX-License-Identifier: BSD-3-Clause
// A packing's arrays for the kernels. Private to the module.
#ifndef vtkSpherePackingArrays_h
#define vtkSpherePackingArrays_h

#include "kernels/SphereArrays.h"

#include "vtkABINamespace.h"

#include <vector>

VTK_ABI_NAMESPACE_BEGIN
class vtkDataArray;
class vtkPolyData;

// Centres and radii that are floats or doubles side by side are used where they are, which has to
// outlive this; others are copied as doubles. `radii` is what vtkSpherePackingInput found; null
// gives no spheres.
class vtkSpherePackingArrays
{
public:
  vtkSpherePackingArrays(vtkPolyData* packing, vtkDataArray* radii);
  vtkSpherePackingArrays(const vtkSpherePackingArrays&) = delete;
  void operator=(const vtkSpherePackingArrays&) = delete;

  const spherepacking::SphereArrays& Get() const { return this->Spheres; }

private:
  spherepacking::SphereArrays Spheres;
  std::vector<double> Centers; // copies, if needed
  std::vector<double> Radii;
};
VTK_ABI_NAMESPACE_END

#endif
