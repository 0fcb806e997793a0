// SPDX-License-Identifier: BSD-3-Clause
#ifndef GivenColumns_h
#define GivenColumns_h

#include "io/PackingFormats.h"
#include "io/TableLayout.h"
#include "io/TextLines.h"

namespace spherepacking
{
/**
 * The layout of a table whose columns the options name; - or _ stands for one to skip. Lines before
 * the first row are skipped if they begin with a letter and hold no number where the sphere should
 * be, so that `text` begins after them. Throws if the names have no coordinates or no radius.
 */
TableLayout LayoutOfColumns(Format format, const ReadOptions& options, TextRange& text);
}

#endif
