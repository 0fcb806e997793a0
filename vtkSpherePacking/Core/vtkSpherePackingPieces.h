// SPDX-License-Identifier: BSD-3-Clause
// Work in pieces that reports after each. Private to the module.
#ifndef vtkSpherePackingPieces_h
#define vtkSpherePackingPieces_h

#include "vtkABINamespace.h"

#include <cstdint>
#include <functional>
#include <vector>

VTK_ABI_NAMESPACE_BEGIN
// Makes pieces 0 to count - 1 on all cores. `report` is called after each, in the calling thread,
// with its number and the part of them that is done, and says whether to stop. Returns for each
// piece whether it was made.
std::vector<char> vtkSpherePackingMakePieces(std::int64_t count,
  const std::function<void(std::int64_t)>& make,
  const std::function<bool(std::int64_t, double)>& report);
VTK_ABI_NAMESPACE_END

#endif
