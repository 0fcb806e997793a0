// SPDX-License-Identifier: BSD-3-Clause
#ifndef LaterNames_h
#define LaterNames_h

#include "io/PackingFormats.h"
#include "io/TableLayout.h"
#include "io/TextChunks.h"

#include <vector>

namespace spherepacking
{
/**
 * Throws if comments behind the first row of `text` name other columns than those of `layout`, as
 * where two files became one. `chunks` are all of `text`; those without comments cost nothing.
 */
void CheckLaterNames(const TextRange& text, const std::vector<TextChunk>& chunks,
  const TableLayout& layout, Radii radii);
}

#endif
