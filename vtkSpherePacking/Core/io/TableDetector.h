// SPDX-License-Identifier: BSD-3-Clause
#ifndef TableDetector_h
#define TableDetector_h

#include "io/PackingFormats.h"
#include "io/TableLayout.h"
#include "io/TextLines.h"

namespace spherepacking
{
/**
 * Detects the columns of a table by its header, by a comment before the first row that serves as
 * one, or else by the first row. On return `text` begins after a header that is no comment. Throws
 * if there is no row, or if the columns of the sphere cannot be detected.
 */
TableLayout DetectTable(Format format, TextRange& text);
}

#endif
