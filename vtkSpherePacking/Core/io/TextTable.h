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
 * Parses the rows of `chunks` in all threads into arrays of their number, single or double. Throws
 * for the first row of the file that does not fit `layout`; `file` is its name, `textEnd` where
 * the text that holds the chunks ends.
 */
PackingArrays ParseTable(const char* textEnd, const TableLayout& layout,
  const std::vector<TextChunk>& chunks, bool single, Progress& progress);
}

#endif
