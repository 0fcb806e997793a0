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

/// Throws a PackingFileError if a packing cannot be written there in that format, as far as that is
/// known before it is. Nothing is left of the attempt.
void CheckWritable(const std::string& file, Format kind);

/**
 * Writes a packing, or throws and leaves an earlier file as it was. Numbers get the shortest digits
 * that read back as the same double, so that they also read back as the same float.
 */
void WritePacking(const std::string& file, const WriteOptions& options, Progress& progress);
}

#endif
