// SPDX-License-Identifier: BSD-3-Clause
#ifndef TableDetector_h
#define TableDetector_h

#include "io/PackingFormats.h"
#include "io/TableLayout.h"
#include "io/TextLines.h"

namespace spherepacking
{
/**
 * Detects the columns of a table: as the options name them, or by a header, the #format of YADE, or
 * comments before the first row, or else by the first row. On return `text` begins after a header
 * that is no comment. Throws if there is no row, or if it is not certain which columns are those of
 * the sphere.
 */
TableLayout DetectTable(Format format, const ReadOptions& options, TextRange& text);
}

#endif
