// SPDX-License-Identifier: BSD-3-Clause
#ifndef SphereFields_h
#define SphereFields_h

#include "bridge/PackingArrays.h"
#include "io/Progress.h"

#include <string_view>
#include <vector>

namespace spherepacking
{
/// The numbers of a sphere as they stand in a file, for formats in which they are not the columns
/// of one table.
struct SphereFields
{
  std::string_view Numbers[4]; ///< x, y, z and the radius or diameter
  vtkIdType Line;              ///< where the error is if they are bad
};

enum class SphereSize
{
  Radius,
  Diameter
};

/// Parses the numbers straight to the precision of the output. Throws a LineError for the first
/// sphere whose centre is not finite or whose radius is not finite or negative.
PackingArrays ParseSpheres(
  const std::vector<SphereFields>& spheres, SphereSize size, bool single, Progress& progress);

/// Adds a further array of whole numbers.
void AddIntegers(PackingArrays& arrays, const char* name, const std::vector<int>& values);
}

#endif
