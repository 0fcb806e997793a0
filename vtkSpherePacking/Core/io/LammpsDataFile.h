// SPDX-License-Identifier: BSD-3-Clause
#ifndef LammpsDataFile_h
#define LammpsDataFile_h

#include "bridge/PackingArrays.h"
#include "io/TextLines.h"

#include <optional>
#include <string>
#include <string_view>

namespace spherepacking
{
/// A section of a LAMMPS data file.
struct LammpsSection
{
  std::string Comment; ///< after its name
  vtkIdType Line;      ///< of its name
  TextRange Rows;
};

/// The parts of a LAMMPS data file, the input of its command read_data, that hold spheres.
struct LammpsDataFile
{
  std::string_view Title; ///< the first line
  vtkIdType Count = -1;   ///< of atoms
  vtkIdType CountLine = 0;
  std::optional<SimulationCell> Cell;
  std::optional<LammpsSection> Atoms;
  std::optional<LammpsSection> Velocities;
};

/// Finds them in a text.
LammpsDataFile ScanLammpsData(const TextRange& text);

/// Whether a text begins as such a file does: a title, and then lines of which one is "N atoms".
bool BeginsAsLammpsData(const char* begin, const char* end);
}

#endif
