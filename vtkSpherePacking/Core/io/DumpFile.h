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
  TextRange Atoms{ nullptr, nullptr, 0 }; ///< the lines of the atoms
};

/// Reads the header of the step that `text` holds.
DumpHeader ReadDumpHeader(const TextRange& text, Radii radii);
}

#endif
