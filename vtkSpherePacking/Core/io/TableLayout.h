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
  Extra, ///< a further number, which becomes a point array
  Text   ///< something that is no number and is left out
};

struct Column
{
  ColumnRole Role;
  std::string Name;
};

/// Where fractions of a periodic box lie in space: Origin + x Edge[0] + y Edge[1] + z Edge[2].
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
  std::optional<BoxFrame> Box; ///< set when the centres are fractions of this box
  std::string Expected;        ///< the columns in words, for messages
};

/**
 * Roles after the names of columns in any letter case: x, y, z, r, rad or radius, d, diam or
 * diameter; a unit in brackets may follow. With a radius a diameter is a further column. Nothing
 * when a coordinate or both sizes are missing.
 * `complaint` is set when a name stands twice.
 */
std::optional<std::vector<Column>> ColumnsFromNames(
  const std::vector<std::string_view>& names, std::string& complaint);

/// Turns further columns whose field in the row at `p` is something, but no number, into text.
void MarkTextColumns(TableLayout& layout, const char* p);

/// Whether `field` is a number and nothing else.
bool IsNumber(std::string_view field);

/// "4 columns: x y z radius", for messages.
std::string DescribeColumns(const std::vector<Column>& columns);
}

#endif
