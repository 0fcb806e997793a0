// SPDX-License-Identifier: BSD-3-Clause
#ifndef TextTable_h
#define TextTable_h

#include "bridge/PackingArrays.h"
#include "io/Progress.h"
#include "io/TableLayout.h"
#include "io/TextChunks.h"

#include <string>
#include <vector>

namespace spherepacking
{
/**
 * Parses the rows of `chunks` in parallel, into arrays of single or double precision. Throws a
 * LineError for the first row that does not fit `layout`. `textEnd` is the end of the text that
 * holds the chunks.
 */
PackingArrays ParseTable(const char* textEnd, const TableLayout& layout,
  const std::vector<TextChunk>& chunks, bool single, Progress& progress);

/// Throws if the last row lacks a line end. Programs that write a time step after the other end
/// every row with one, so that one was stopped, perhaps within a number.
void CheckNotCut(const TextRange& rows);

/// Throws unless `chunks` hold as many rows, "atoms" say, as the file says in `line`.
void CheckCount(
  vtkIdType count, const std::string& things, vtkIdType line, const std::vector<TextChunk>& chunks);
}

#endif
