// SPDX-License-Identifier: BSD-3-Clause
#ifndef DumpFile_h
#define DumpFile_h

#include "io/TableLayout.h"
#include "io/TextLines.h"

#include "bridge/PackingArrays.h"

#include <optional>

namespace spherepacking
{
/// The header of a dump's time step, that is the lines before its atoms.
struct DumpHeader
{
  TableLayout Layout;
  std::optional<SimulationCell> Cell;
  vtkIdType Count = -1;
  vtkIdType CountLine = 0;
  TextRange Atoms{ nullptr, nullptr, 0 }; ///< what follows
};

/// Whether `text`, which begins with a step, has the whole header of it.
bool HasDumpHeader(const TextRange& text);

/// Reads the header of the step that begins `text`.
DumpHeader ReadDumpHeader(const TextRange& text, Radii radii);

/// The end of the atoms with which `text` begins: the next title, which need not be that of the
/// next step, or what was written of one when the run was stopped.
const char* EndOfAtoms(const TextRange& text);
}

#endif
