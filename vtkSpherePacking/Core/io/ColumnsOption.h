// SPDX-License-Identifier: BSD-3-Clause
#ifndef ColumnsOption_h
#define ColumnsOption_h

#include "io/PackingFormats.h"
#include "io/TableLayout.h"

#include <optional>
#include <vector>

namespace spherepacking
{
/// Whether the options ask for radii.
inline Radii RadiiOf(const ReadOptions& options)
{
  return options.RadiusOptional ? Radii::Optional : Radii::Required;
}

/// The columns that the options name; nothing if they name none. Throws a ContentError if x, y, z
/// or a radius is missing among them.
std::optional<std::vector<Column>> ColumnsOfOption(const ReadOptions& options);
}

#endif
