// SPDX-License-Identifier: BSD-3-Clause
#ifndef UnitsBesideNames_h
#define UnitsBesideNames_h

#include "io/TableColumn.h"
#include "io/TextLines.h"

#include <string_view>
#include <vector>

namespace spherepacking
{
/// Whether the fields of a line are units, three or more of them of length, with or without
/// brackets; a - stands for none.
bool AreUnits(const std::vector<std::string_view>& fields);

/// Throws if `fields`, units of `columns` in `line`, give coordinates and radii several units of
/// length, or others than the names of these columns do.
void CheckUnitsOfColumns(const TextRange& line, const std::vector<std::string_view>& fields,
  const std::vector<Column>& columns);

/// Throws if one of the remarks beside named columns gives lengths in several units. Remarks that
/// are names of the columns themselves do not count.
void CheckUnitsOfRemarks(const std::vector<TextRange>& remarks, const std::vector<Column>& columns);
}

#endif
