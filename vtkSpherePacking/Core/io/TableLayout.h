// SPDX-License-Identifier: BSD-3-Clause
#ifndef TableLayout_h
#define TableLayout_h

#include "bridge/PackingArrays.h"
#include "io/ColumnNames.h"
#include "io/CutFile.h"
#include "io/Separators.h"
#include "io/TableColumn.h"
#include "io/TextChunks.h"

#include <optional>
#include <string>
#include <vector>

namespace spherepacking
{
/// Which columns of a table somebody has named.
enum class Naming : unsigned char
{
  All,
  FirstFour,      ///< x, y, z and radius, but not all others
  FourAfterWords, ///< the same of only four, after words that may be a name, too
  None
};

/// How to read the rows of a table.
struct TableLayout
{
  std::vector<Column> Columns;
  Separators Between = Separators::Liberal();
  std::optional<SimulationCell> Box; ///< if the coordinates are scaled, that is fractions of it
  std::string Expected;              ///< describes the columns, for messages
  Naming Named = Naming::All;
  std::optional<SimulationCell> Cell; ///< that of the packing, where the header gives one
  LineEnds Ends = LineEnds::ByPeople;
};

/// Makes those further columns text that hold anything but a number in the row at `p`; an empty
/// field does not count.
void MarkTextColumns(TableLayout& layout, const char* p);

/// The same by the first row of `rows`, if there is any.
void MarkTextByFirstRow(TableLayout& layout, const TextRange& rows);

/// Throws if a table has more columns than any packing: each is an array of VTK, which takes about
/// a kilobyte whatever it holds, so that a short row could take more memory than its file explains.
void CheckColumnCount(std::size_t count);

/// Whether a radius or diameter is among the columns.
bool HasRadius(const std::vector<Column>& columns);

/// Whether the whole of `field` is a number.
bool IsNumber(std::string_view field);

/// "4 columns: x y z radius", for messages.
std::string DescribeColumns(const std::vector<Column>& columns);
}

#endif
