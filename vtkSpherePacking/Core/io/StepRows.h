// SPDX-License-Identifier: BSD-3-Clause
#ifndef StepRows_h
#define StepRows_h

#include "bridge/PackingArrays.h"
#include "io/CutFile.h"
#include "io/LineBlocks.h"
#include "io/PackingFormats.h"
#include "io/TableLayout.h"

#include <functional>
#include <string>

namespace spherepacking
{
/// What a step says of its rows before they begin.
struct StepRows
{
  const char* Begin; ///< in the current block
  vtkIdType Count;
  vtkIdType CountLine; ///< the line of the block that holds the count
  const char* Things;  ///< of which there are so many, such as "atoms"
  LineEnds Ends = LineEnds::ByProgram;
  /// Where the rows that begin a text end, if they do.
  std::function<const char*(const TextRange&)> End = [](const TextRange& text) { return text.End; };
};

/// Reads the rows of a step, of which `blocks` has the first block. Each block is parsed by all
/// threads before the next is read.
PackingArrays ReadStepRows(LineBlocks& blocks, const StepRows& rows, const TableLayout& layout,
  const ReadOptions& options, Progress& progress);
}

#endif
