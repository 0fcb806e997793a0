// SPDX-License-Identifier: BSD-3-Clause
#ifndef TableDetector_h
#define TableDetector_h

#include "io/PackingFormats.h"
#include "io/TableLayout.h"
#include "io/TextLines.h"

namespace spherepacking
{
/**
 * Finds the columns of a table from its header, from a comment before the first row that is one,
 * or else from the first row. On return `text` begins after a header that is no comment. Throws
 * when there is no row or no telling where the sphere is.
 */
TableLayout DetectTable(Format format, TextRange& text);
}

#endif
