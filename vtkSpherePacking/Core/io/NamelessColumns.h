// SPDX-License-Identifier: BSD-3-Clause
#ifndef NamelessColumns_h
#define NamelessColumns_h

#include "io/PackingFormats.h"
#include "io/TableLayout.h"
#include "io/TextLines.h"

#include <cstddef>
#include <string>
#include <vector>

namespace spherepacking
{
/// What a user can say instead, for messages.
extern const char* const ColumnsHint;

/// The same where rows have `count` columns.
std::string HintFor(std::size_t count);

/**
 * The columns of rows like `row`, in which `text` begins: x, y, z and radius come first, or in
 * `.xyzr` may come last. But for `.xyzr`, no place is that of the radius if it is optional: who
 * gives radii need not have any in the file. Throws if there are too few, or if it is not certain
 * which they are.
 */
std::vector<Column> NamelessColumns(
  Format format, const TextRange& text, const TextRange& row, Radii radii);
}

#endif
