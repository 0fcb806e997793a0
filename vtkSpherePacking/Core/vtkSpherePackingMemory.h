// SPDX-License-Identifier: BSD-3-Clause
// How much memory a structure may take. Private to the module.
#ifndef vtkSpherePackingMemory_h
#define vtkSpherePackingMemory_h

#include "vtkABINamespace.h"

#include <vtksys/SystemInformation.hxx>

VTK_ABI_NAMESPACE_BEGIN
// Half of the machine's memory, in bytes.
inline double vtkSpherePackingHalfOfMemory()
{
  vtksys::SystemInformation system;
  return 0.5 * 1024.0 * static_cast<double>(system.GetHostMemoryTotal());
}
VTK_ABI_NAMESPACE_END

#endif
