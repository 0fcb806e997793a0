// SPDX-License-Identifier: BSD-3-Clause
// How far the spheres of a packing may reach. Private to the module.
#ifndef vtkSpherePackingExtent_h
#define vtkSpherePackingExtent_h

#include "vtkABINamespace.h"

VTK_ABI_NAMESPACE_BEGIN
// Throws a std::invalid_argument if differences of these bounds are not finite.
void vtkSpherePackingCheckFinite(const double (&bounds)[6]);

// Throws a std::invalid_argument if rays cannot be cast at spheres within these bounds: depths are
// kept in single precision, and squares of lengths must be numbers.
void vtkSpherePackingCheckExtent(const double (&bounds)[6]);
VTK_ABI_NAMESPACE_END

#endif
