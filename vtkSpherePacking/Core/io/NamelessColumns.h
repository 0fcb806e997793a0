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
 * Throws if the first column holds ids or kinds rather than x: if there are more than four columns,
 * and in the first only whole numbers without a sign or point, no two of them the same, or beside y
 * and z that are written with a point. Nobody else writes all x so.
 */
void CheckFirstColumn(const TextRange& text, const TableLayout& layout);

/// Throws if the first row holds the number of the others and three lengths or six bounds of a box
/// that they lie in.
void CheckFirstRow(const TextRange& text, const PackingArrays& arrays);
}

#endif
