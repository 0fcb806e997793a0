// SPDX-License-Identifier: BSD-3-Clause
#ifndef CheckPlaces_h
#define CheckPlaces_h

#include "bridge/PackingArrays.h"
#include "io/TableLayout.h"
#include "io/TextLines.h"

namespace spherepacking
{
/**
 * Throws if the first column of a table may not be x, although its columns go by their places: if
 * there are more than four, or four without a radius, and the first may hold ids, kinds or times,
 * or if the first row may hold a count and a box. `text` begins with the first row or comments
 * before it.
 */
void CheckPlaces(const TextRange& text, const TableLayout& layout, const PackingArrays& arrays);
}

#endif
