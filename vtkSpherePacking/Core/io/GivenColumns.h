// SPDX-License-Identifier: BSD-3-Clause
#ifndef GivenColumns_h
#define GivenColumns_h

#include "io/PackingFormats.h"
#include "io/TableLayout.h"
#include "io/TextLines.h"

#include <vector>

namespace spherepacking
{
/// Whether the options ask for radii.
inline Radii RadiiOf(const ReadOptions& options)
{
  return options.RadiusOptional ? Radii::Optional : Radii::Required;
}

/// The columns that the options name; - or _ stands for one to skip. Throws if the names have no
/// coordinates or no radius.
std::vector<Column> GivenColumns(const ReadOptions& options);

/**
 * The layout of a table whose columns the options name. Lines before
 * the first row are skipped if they begin with a letter and hold no number where the sphere should
 * be, so that `text` begins after them. Throws if the names have no coordinates or no radius.
 */
TableLayout LayoutOfColumns(Format format, const ReadOptions& options, TextRange& text);
}

#endif
