// SPDX-License-Identifier: BSD-3-Clause
// A packing as plain spheres in double precision, for the kernels. Private to the module.
#ifndef vtkSpherePackingSpheres_h
#define vtkSpherePackingSpheres_h

#include "kernels/Sphere.h"

#include "vtkABINamespace.h"

#include <vector>

VTK_ABI_NAMESPACE_BEGIN
class vtkDataArray;
class vtkPolyData;

// One sphere a point, in the order of the points. `radii` is what vtkSpherePackingInput found; null
// gives none.
std::vector<spherepacking::Sphere> vtkSpherePackingSpheresOf(
  vtkPolyData* packing, vtkDataArray* radii);
VTK_ABI_NAMESPACE_END

#endif
