// SPDX-License-Identifier: BSD-3-Clause
#ifndef TableLayout_h
#define TableLayout_h

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

/// The periodic box of scaled coordinates: x, y, z lie at Origin + x Edges[0] + y Edges[1] +
/// z Edges[2].
struct BoxFrame
{
  double Origin[3];
  double Edges[3][3];
};

/// How to read the rows of a table.
struct TableLayout
{
  std::vector<Column> Columns;
  Separators Between = Separators::Liberal();
  RowKind Rows = RowKind::Data;
  std::optional<BoxFrame> Box; ///< if the coordinates are scaled, that is fractions of this box
  std::string Expected;        ///< describes the columns, for messages
};

/**
 * Finds the roles of columns by their names, in any letter case: x, y, z, r, rad or radius, d, diam
 * or diameter, perhaps followed by a unit in brackets. Beside a radius a diameter is a further
 * column. Returns nothing if a coordinate or both radius and diameter are missing; sets `complaint`
 * if two names mean the same column.
 */
std::optional<std::vector<Column>> ColumnsFromNames(
  const std::vector<std::string_view>& names, std::string& complaint);

/// Makes those further columns text that hold anything but a number in the row at `p`; an empty
/// field does not count.
void MarkTextColumns(TableLayout& layout, const char* p);

/// Whether the whole of `field` is a number.
bool IsNumber(std::string_view field);

/// "4 columns: x y z radius", for messages.
std::string DescribeColumns(const std::vector<Column>& columns);
}

#endif
