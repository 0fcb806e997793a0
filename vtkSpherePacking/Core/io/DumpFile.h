// SPDX-License-Identifier: BSD-3-Clause
#ifndef DumpFile_h
#define DumpFile_h

#include "io/TableLayout.h"
#include "io/TextLines.h"

#include <string>
#include <vector>

namespace spherepacking
{
/// Where a time step lies in a dump.
struct DumpStep
{
  double Time;
  unsigned long long Begin;
  unsigned long long End;
  vtkIdType FirstLine;
};

/**
 * The steps of a LAMMPS or LIGGGHTS dump (A. Thompson et al., "LAMMPS - a flexible simulation
 * tool", 2022), found in one pass over the file that keeps only a block of it in memory, as such
 * files are often larger than that. Time is what ITEM: TIMESTEP says.
 */
std::vector<DumpStep> FindDumpSteps(const std::string& file);

/// What the lines of a step before its atoms say.
struct DumpHeader
{
  TableLayout Layout;
  vtkIdType Count;
  vtkIdType CountLine;
  TextRange Atoms; ///< up to the end of the step
};

/// Reads the header of the step that `text` holds.
DumpHeader ReadDumpHeader(const TextRange& text);
}

#endif
