// SPDX-License-Identifier: BSD-3-Clause
#include "io/TableLayout.h"

#include "io/Number.h"
#include "io/PackingFileError.h"

#include "vtk_utf8.h"

#include <algorithm>
#include <array>
#include <map>

namespace spherepacking
{
namespace
{
// "diameter" of "diameter [mm]" and "diameter(mm)".
std::string_view WithoutUnit(std::string_view name)
{
  const std::size_t unit = std::min(name.find_first_of("(["), name.size());
  const std::size_t last = name.substr(0, unit).find_last_not_of(" \t");
  return name.substr(0, last == name.npos ? 0 : last + 1);
}

ColumnRole RoleOfName(std::string_view name)
{
  static const std::map<std::string, ColumnRole> roles{ { "x", ColumnRole::X },
    { "y", ColumnRole::Y }, { "z", ColumnRole::Z }, { "r", ColumnRole::Radius },
    { "radius", ColumnRole::Radius }, { "rad", ColumnRole::Radius }, { "d", ColumnRole::Diameter },
    { "diameter", ColumnRole::Diameter }, { "diam", ColumnRole::Diameter } };
  std::string lower(WithoutUnit(name));
  // Not std::tolower, which depends on the locale.
  std::transform(lower.begin(), lower.end(), lower.begin(),
    [](char c) { return c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c; });
  const auto found = roles.find(lower);
  return found == roles.end() ? ColumnRole::Extra : found->second;
}

// The name of an array must be UTF-8; bytes of another encoding are escaped.
std::string ArrayName(std::string_view name)
{
  const auto isControl = [](char c) { return c >= 0 && c < ' '; };
  if (utf8::is_valid(name.begin(), name.end()) && std::none_of(name.begin(), name.end(), isControl))
  {
    return std::string(name);
  }
  const std::string quoted = Quote(name.data(), name.data() + name.size());
  return quoted.substr(1, quoted.size() - 2);
}
}

//------------------------------------------------------------------------------
std::optional<std::vector<Column>> ColumnsFromNames(
  const std::vector<std::string_view>& names, std::string& complaint, Radii radii)
{
  std::vector<Column> columns;
  std::array<int, 5> count{};
  for (const std::string_view name : names)
  {
    const ColumnRole role = RoleOfName(name);
    if (role != ColumnRole::Extra)
    {
      ++count[static_cast<int>(role)];
    }
    columns.push_back({ role, ArrayName(name) });
  }
  const auto has = [&](ColumnRole role) { return count[static_cast<int>(role)] > 0; };
  if (!has(ColumnRole::X) || !has(ColumnRole::Y) || !has(ColumnRole::Z) ||
    !(radii == Radii::Optional || has(ColumnRole::Radius) || has(ColumnRole::Diameter)))
  {
    return std::nullopt;
  }
  std::map<std::string, int> seen;
  for (std::size_t i = 0; i < columns.size(); ++i)
  {
    Column& column = columns[i];
    if (column.Role == ColumnRole::Diameter && has(ColumnRole::Radius))
    {
      column.Role = ColumnRole::Extra;
    }
    if (column.Name.empty())
    {
      column.Name = "column_" + std::to_string(i + 1);
    }
    // Two columns of one role, by the same name or by two such as r and radius.
    const std::string key = column.Role == ColumnRole::Extra
      ? column.Name
      : "/" + std::to_string(static_cast<int>(column.Role));
    if (const auto [at, fresh] = seen.emplace(key, i); !fresh)
    {
      const std::string& earlier = columns[at->second].Name;
      complaint = "found the columns " + Quote(earlier.data(), earlier.data() + earlier.size()) +
        " and " + Quote(column.Name.data(), column.Name.data() + column.Name.size()) +
        ", which name one thing twice, expected each name once";
    }
  }
  return columns;
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
    if (IsRow(layout.Rows, p, end))
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
  std::string text = std::to_string(columns.size()) + " columns:";
  for (const Column& column : columns)
  {
    text += ' ' + column.Name;
  }
  return text;
}
}
