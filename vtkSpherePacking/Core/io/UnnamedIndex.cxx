// SPDX-License-Identifier: BSD-3-Clause
#include "io/UnnamedIndex.h"

#include "io/TableRows.h"

#include <string>
#include <string_view>

namespace spherepacking
{
//------------------------------------------------------------------------------
UnnamedIndex FindIndex(const TextRange& rows, const Separators& between, std::size_t indent)
{
  vtkIdType count = 0;
  vtkIdType first = 0;
  bool counts = true;
  bool quoted = true;
  bool leftOfNames = true;
  bool pointBeside = false;
  ForRows(rows,
    [&](const TextRange& row)
    {
      const char* const end = between.FieldEnd(row.Begin);
      std::string_view field(row.Begin, end - row.Begin);
      leftOfNames &= field.size() < indent && (row.Begin == rows.Begin || IsLineEnd(row.Begin[-1]));
      const bool inQuotes = field.size() > 2 && field.front() == '"' && field.back() == '"';
      field = inQuotes ? field.substr(1, field.size() - 2) : field;
      quoted &= inQuotes;
      pointBeside |= std::string_view(end, row.End - end).find('.') != std::string_view::npos;
      first = count == 0 && field == "1" ? 1 : first;
      counts = field == std::to_string(first + count);
      ++count;
      return counts;
    });
  const bool certain = quoted || leftOfNames || (count >= 3 && pointBeside);
  return !counts || count == 0 || (count == 1 && !certain) ? UnnamedIndex::None
    : certain                                              ? UnnamedIndex::Certain
                                                           : UnnamedIndex::Possible;
}
}
