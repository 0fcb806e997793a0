// SPDX-License-Identifier: BSD-3-Clause
#ifndef TableLayout_h
#define TableLayout_h

#include "bridge/PackingArrays.h"
#include "io/Separators.h"
#include "io/TextChunks.h"

#include <optional>
#include <string>
#include <vector>

namespace spherepacking
{
/// What a column of a table holds.
enum class ColumnRole : unsigned char
{
  X,
  Y,
  Z,
  Radius,
  Diameter,
  Extra, ///< further numbers, which become a point array
  Text   ///< anything else, which is skipped
};

struct Column
{
  ColumnRole Role;
  std::string Name;
};

/// How to read the rows of a table.
struct TableLayout
{
  std::vector<Column> Columns;
  Separators Between = Separators::Liberal();
  RowKind Rows = RowKind::Data;
  std::optional<SimulationCell>
    Box;                ///< if the coordinates are scaled, that is fractions of this box
  std::string Expected; ///< describes the columns, for messages
};

/// Whether a table may be without radii.
enum class Radii
{
  Required,
  Optional
};

/**
 * Finds the roles of columns by their names, in any letter case: x, y, z, r, rad or radius, d, diam
 * or diameter, perhaps followed by a unit in brackets. Beside a radius a diameter is a further
 * column. Returns nothing if a coordinate is missing, or both radius and diameter unless these are
 * optional; sets `complaint`
 * if two names mean the same column.
 */
std::optional<std::vector<Column>> ColumnsFromNames(const std::vector<std::string_view>& names,
  std::string& complaint, Radii radii = Radii::Required);

/// Makes those further columns text that hold anything but a number in the row at `p`; an empty
/// field does not count.
void MarkTextColumns(TableLayout& layout, const char* p);

/// The same by the first row of `rows`, if there is any.
void MarkTextByFirstRow(TableLayout& layout, const TextRange& rows);

/// Whether a radius or diameter is among the columns.
bool HasRadius(const std::vector<Column>& columns);

/// Whether the whole of `field` is a number.
bool IsNumber(std::string_view field);

/// "4 columns: x y z radius", for messages.
std::string DescribeColumns(const std::vector<Column>& columns);
}

#endif
