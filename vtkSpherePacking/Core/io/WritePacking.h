// SPDX-License-Identifier: BSD-3-Clause
#ifndef WritePacking_h
#define WritePacking_h

#include "io/PackingFormats.h"
#include "io/Progress.h"

#include "vtkType.h"

#include <string>
#include <vector>

class vtkDataArray;
class vtkPolyData;

namespace spherepacking
{
/// What to write and how. The radii have been checked and there is at least one sphere.
struct WriteOptions
{
  Format Kind = Format::Auto;
  vtkPolyData* Packing = nullptr;
  vtkDataArray* Radii = nullptr;
  bool SortByRadius = true;
};

/**
 * Writes a packing, or throws and leaves an earlier file as it was. Numbers get the shortest digits
 * that read back as the same double, so that they also read back as the same float.
 */
void WritePacking(const std::string& file, const WriteOptions& options, Progress& progress);
}

#endif
