// SPDX-License-Identifier: BSD-3-Clause
#include "io/TableLayout.h"

#include "io/Number.h"
#include "io/PackingFileError.h"

#include <algorithm>

namespace spherepacking
{
//------------------------------------------------------------------------------
void CheckColumnCount(std::size_t count)
{
  constexpr std::size_t most = 1 << 15;
  if (count > most)
  {
    throw ContentError(
      "found " + std::to_string(count) + " columns, expected at most " + std::to_string(most));
  }
}

//------------------------------------------------------------------------------
bool HasRadius(const std::vector<Column>& columns)
{
  return std::any_of(columns.begin(), columns.end(), [](const Column& column)
    { return column.Role == ColumnRole::Radius || column.Role == ColumnRole::Diameter; });
}

//------------------------------------------------------------------------------
bool IsNumber(std::string_view field)
{
  double value;
  const char* end = field.data() + field.size();
  return ParseNumber(field.data(), end, value) == end;
}

//------------------------------------------------------------------------------
void MarkTextColumns(TableLayout& layout, const char* p)
{
  const auto fields = layout.Between.Split(p);
  for (std::size_t i = 0; i < layout.Columns.size() && i < fields.size(); ++i)
  {
    Column& column = layout.Columns[i];
    if (column.Role == ColumnRole::Extra && !fields[i].empty() && !IsNumber(fields[i]))
    {
      column.Role = ColumnRole::Text;
    }
  }
}

//------------------------------------------------------------------------------
void MarkTextByFirstRow(TableLayout& layout, const TextRange& rows)
{
  LineFinder find(rows.End);
  for (const char* p = rows.Begin; p != rows.End;)
  {
    const char* end = find(p);
    if (IsRow(RowKind::Data, p, end))
    {
      MarkTextColumns(layout, p);
      return;
    }
    p = SkipLineEnd(end, rows.End);
  }
}

//------------------------------------------------------------------------------
std::string DescribeColumns(const std::vector<Column>& columns)
{
  constexpr std::size_t most = 20;
  std::string text = std::to_string(columns.size()) + " columns:";
  for (std::size_t i = 0; i < columns.size() && i < most; ++i)
  {
    text += ' ' + columns[i].Name;
  }
  return columns.size() > most ? text + " ..." : text;
}
}
