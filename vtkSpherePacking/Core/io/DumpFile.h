// SPDX-License-Identifier: BSD-3-Clause
#ifndef DumpFile_h
#define DumpFile_h

#include "io/TableLayout.h"
#include "io/TextLines.h"

#include <string>
#include <vector>

namespace spherepacking
{
/// A time step of a dump: its time, the range of its bytes, and its first line.
struct DumpStep
{
  double Time;
  unsigned long long Begin;
  unsigned long long End;
  vtkIdType FirstLine;
};

/**
 * Finds the time steps of a LAMMPS or LIGGGHTS dump (A. Thompson et al., "LAMMPS - a flexible
 * simulation tool for particle-based materials modeling at the atomic, meso, and continuum scales",
 * 2022), by ITEM: TIMESTEP. One pass with a block of the file in memory at a time, since dumps are
 * often larger than that.
 */
std::vector<DumpStep> FindDumpSteps(const std::string& file);

/// The header of a time step, that is the lines before its atoms.
struct DumpHeader
{
  TableLayout Layout;
  vtkIdType Count;
  vtkIdType CountLine;
  TextRange Atoms; ///< the lines of the atoms
};

/// Reads the header of the step that `text` holds.
DumpHeader ReadDumpHeader(const TextRange& text);
}

#endif
