// SPDX-License-Identifier: BSD-3-Clause
/// Tables whose columns nobody names: which are those of the sphere, and when that is not certain.
#ifndef NamelessColumns_h
#define NamelessColumns_h

#include "bridge/PackingArrays.h"
#include "io/PackingFormats.h"
#include "io/TableLayout.h"
#include "io/TextLines.h"

#include <vector>

namespace spherepacking
{
/// What a user can say instead, for messages.
extern const char* const ColumnsHint;

/**
 * The columns of rows like `row`, in which `text` begins: x, y, z and radius come first, or in
 * `.xyzr` may come last. Throws if there are too few, or if it is not certain which they are.
 */
std::vector<Column> NamelessColumns(
  Format format, const TextRange& text, const TextRange& row, Radii radii);

/**
 * Throws if the first of more than four columns may hold ids or kinds rather than x, unless all are
 * named: if it has only whole numbers without sign and point, beside y or z with a point somewhere,
 * or, where nobody says that x comes first, no two of them the same.
 */
void CheckFirstColumn(const TextRange& text, const TableLayout& layout);

/// Throws if the first row holds the number of the others and three lengths or six bounds of a box
/// that they lie in.
void CheckFirstRow(const TextRange& text, const PackingArrays& arrays);
}

#endif
