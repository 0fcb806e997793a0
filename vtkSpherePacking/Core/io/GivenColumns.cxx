// SPDX-License-Identifier: BSD-3-Clause
#include "io/GivenColumns.h"

#include "io/PackingFileError.h"
#include "io/TableHead.h"

#include <algorithm>
#include <string_view>
#include <vector>

namespace spherepacking
{
namespace
{
using Fields = std::vector<std::string_view>;

// Separators that make as many fields of a row as there are columns.
Separators SeparatorsFor(Format format, const TextRange& row, std::size_t count)
{
  if (format != Format::Csv && Separators::Liberal().Split(row.Begin).size() == count)
  {
    return Separators::Liberal();
  }
  for (const char delimiter : { ';', '\t', ',' })
  {
    const Separators strict = Separators::Strict(delimiter);
    if (strict.Split(row.Begin).size() == count)
    {
      return strict;
    }
  }
  return Separators::Liberal();
}

// Whether a line cannot be a row: it begins with a letter and has no number for any coordinate.
bool IsProse(const TextRange& line, const TableLayout& layout)
{
  const Fields fields = layout.Between.Split(line.Begin);
  const auto isLetter = [](char c)
  {
    return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || c < 0 || c == '"' || c == '/' ||
      c == '[' || c == '(';
  };
  bool number = !isLetter(*line.Begin);
  for (std::size_t i = 0; i < fields.size() && i < layout.Columns.size(); ++i)
  {
    number |= layout.Columns[i].Role <= ColumnRole::Diameter && IsNumber(fields[i]);
  }
  return !number;
}
}

//------------------------------------------------------------------------------
std::vector<Column> GivenColumns(const ReadOptions& options)
{
  const std::string& text = options.Columns;
  Fields names;
  for (std::size_t p = 0; p < text.size();)
  {
    const std::size_t begin = std::min(text.find_first_not_of(" \t\n,;", p), text.size());
    const std::size_t end = std::min(text.find_first_of(" \t\n,;", begin), text.size());
    if (begin != end)
    {
      names.push_back(std::string_view(text).substr(begin, end - begin));
    }
    p = end;
  }
  const auto isSkipped = [](std::string_view name) { return name == "-" || name == "_"; };
  Fields wanted;
  std::remove_copy_if(names.begin(), names.end(), std::back_inserter(wanted), isSkipped);

  std::string complaint;
  const auto found = ColumnsFromNames(wanted, complaint, RadiiOf(options), NamesBy::User);
  std::string unused;
  if (!found && ColumnsFromNames(wanted, unused, Radii::Optional, NamesBy::User))
  {
    throw ContentError("columns: found no radius in " +
      Quote(text.data(), text.data() + text.size()) +
      ", expected one of r, radius, d, diameter; or radius= (--radius) to give radii");
  }
  if (!found || !complaint.empty())
  {
    throw ContentError(!complaint.empty()
        ? "columns: " + complaint
        : "columns: found " + Quote(text.data(), text.data() + text.size()) +
          ", expected x, y, z and one of r, radius, d, diameter");
  }
  std::vector<Column> columns;
  auto next = found->begin();
  for (const std::string_view name : names)
  {
    columns.push_back(isSkipped(name) ? Column{ ColumnRole::Skipped, "-" } : *next++);
  }
  return columns;
}

//------------------------------------------------------------------------------
TableLayout LayoutOfColumns(Format format, const ReadOptions& options, TextRange& text)
{
  TableLayout layout;
  layout.Columns = GivenColumns(options);
  layout.Expected = DescribeColumns(layout.Columns);
  for (;;)
  {
    const TextRange row = FindHead(text).Row;
    layout.Between = SeparatorsFor(format, row, layout.Columns.size());
    if (!IsProse(row, layout))
    {
      MarkTextColumns(layout, row.Begin);
      return layout;
    }
    text = { SkipLineEnd(row.End, text.End), text.End, row.FirstLine + 1 };
  }
}
}
