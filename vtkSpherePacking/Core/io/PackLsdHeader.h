// SPDX-License-Identifier: BSD-3-Clause
#ifndef PackLsdHeader_h
#define PackLsdHeader_h

#include "bridge/PackingArrays.h"
#include "io/LineScanner.h"

#include <string_view>
#include <vector>

namespace spherepacking
{
/**
 * The lines before the centres in a file of PackLSD and its successors in C++ (A. Donev et al.,
 * "Neighbor list collision-driven molecular dynamics simulation for nonspherical particles", 2005):
 * the dimension, the numbers of spheres and of species, the number of spheres of each species, the
 * diameter of each species unless each sphere has its own, the vectors of the cell, and T or F for
 * each of its axes that is periodic or not.
 */
struct PackLsdHeader
{
  vtkIdType Count;
  vtkIdType CountLine;
  std::vector<vtkIdType> Counts;
  std::vector<std::string_view> Diameters; ///< of each species, or empty
  SimulationCell Cell;
};

/// Reads these lines; throws a LineError if they are not so.
PackLsdHeader ReadPackLsdHeader(LineScanner& scanner);
}

#endif
