// SPDX-License-Identifier: BSD-3-Clause
#include "io/TableDetector.h"

#include "io/PackingFileError.h"

#include <algorithm>
#include <string_view>
#include <vector>

namespace spherepacking
{
namespace
{
using Fields = std::vector<std::string_view>;

// The lines at the beginning of a table that say what its columns are.
struct Head
{
  std::string_view YadeNames;               // the field after #format
  TextRange Comment{ nullptr, nullptr, 0 }; // the last one that names columns, if any
  TextRange Row{ nullptr, nullptr, 0 };
};

// The names that a comment may give to columns: its fields, except units and a leading label such
// as "columns:".
Fields NamesOfComment(const char* comment)
{
  Fields names;
  for (std::string_view name : Separators::Liberal().Split(comment))
  {
    const bool colon = !name.empty() && name.back() == ':';
    const bool label = colon && names.empty() && name.size() > 2;
    const bool unit = !name.empty() && (name.front() == '(' || name.front() == '[');
    if (!label && !unit)
    {
      name.remove_suffix(colon ? 1 : 0);
      names.push_back(name);
    }
  }
  return names;
}

Head FindHead(const TextRange& text)
{
  Head head;
  LineFinder find(text.End);
  vtkIdType number = text.FirstLine;
  for (const char* p = text.Begin; p != text.End; ++number)
  {
    const char* end = find(p);
    const char* first = SkipBlanks(p, end);
    if (IsRow(RowKind::Data, p, end))
    {
      head.Row = { first, end, number };
      return head;
    }
    if (first != end)
    {
      const char* comment = first;
      while (comment != end && *comment == '#')
      {
        ++comment;
      }
      std::string complaint;
      if (ColumnsFromNames(NamesOfComment(comment), complaint))
      {
        head.Comment = { comment, end, number };
      }
      const Fields fields = Separators::Liberal().Split(comment);
      if (first + 1 == comment && fields.size() >= 2 && fields[0] == "format" && *comment == 'f')
      {
        head.YadeNames = fields[1];
      }
    }
    p = SkipLineEnd(end, text.End);
  }
  ThrowNoSphere("lines of x y z radius");
}

// Whether a row has commas right between digits, as in 1,5 for one and a half, besides other
// separators and no point. Taken for separators they would make two numbers of each.
bool HasDecimalCommas(const TextRange& row)
{
  bool bareComma = false;
  bool other = false;
  for (const char* p = row.Begin; p != row.End && *p != '#'; ++p)
  {
    const auto digitAt = [&](const char* q)
    { return q >= row.Begin && q != row.End && *q >= '0' && *q <= '9'; };
    if (*p == '.')
    {
      return false;
    }
    bareComma |= *p == ',' && digitAt(p - 1) && digitAt(p + 1);
    const bool beforeNumber = digitAt(p + 1) || (p + 1 != row.End && (p[1] == '-' || p[1] == '+'));
    other |= *p == ';' || (IsBlank(*p) && beforeNumber);
  }
  return bareComma && other;
}

// The first of `delimiters` that stands in `header`, or 0.
char FindDelimiter(const TextRange& header, std::string_view delimiters)
{
  for (const char delimiter : delimiters)
  {
    if (std::find(header.Begin, header.End, delimiter) != header.End)
    {
      return delimiter;
    }
  }
  return 0;
}

std::vector<Column> ColumnsFromHeader(const TextRange& line, const Separators& between)
{
  std::string complaint;
  const auto columns = ColumnsFromNames(between.Split(line.Begin), complaint);
  if (!columns)
  {
    throw LineError(line.FirstLine,
      "found the columns " + Quote(line.Begin, line.End) +
        ", expected a header that names x, y, z and one of r, radius, d, diameter");
  }
  if (!complaint.empty())
  {
    throw LineError(line.FirstLine, complaint);
  }
  return *columns;
}

// Numbered columns for `fields`, but for x, y, z and radius at the given indices.
std::vector<Column> NamelessColumns(const Fields& fields, const std::vector<std::size_t>& sphere)
{
  std::vector<Column> columns;
  for (std::size_t i = 0; i < fields.size(); ++i)
  {
    columns.push_back({ ColumnRole::Extra, "column_" + std::to_string(i + 1) });
  }
  const Column components[4] = { { ColumnRole::X, "x" }, { ColumnRole::Y, "y" },
    { ColumnRole::Z, "z" }, { ColumnRole::Radius, "radius" } };
  for (std::size_t i = 0; i < 4; ++i)
  {
    columns[sphere[i]] = components[i];
  }
  return columns;
}

[[noreturn]] void ThrowTooFew(const Head& head, std::size_t found, const char* kind)
{
  throw LineError(head.Row.FirstLine,
    "found " + std::to_string(found) + kind + (found == 1 ? "column " : "columns ") +
      Quote(head.Row.Begin, head.Row.End) + ", expected at least 4: x y z radius");
}

std::vector<Column> FirstFour(const Head& head, const Fields& fields)
{
  if (fields.size() < 4)
  {
    ThrowTooFew(head, fields.size(), " ");
  }
  return NamelessColumns(fields, { 0, 1, 2, 3 });
}

std::vector<Column> LastFourNumeric(const Head& head, const Fields& fields)
{
  std::vector<std::size_t> numeric;
  for (std::size_t i = 0; i < fields.size(); ++i)
  {
    if (IsNumber(fields[i]))
    {
      numeric.push_back(i);
    }
  }
  if (numeric.size() < 4)
  {
    ThrowTooFew(head, numeric.size(), " numeric ");
  }
  return NamelessColumns(fields, { numeric.end() - 4, numeric.end() });
}

// #format x_y_z_r_attrs names all but the columns that attrs stands for, of which there may be
// none.
std::vector<Column> ColumnsOfYade(const Head& head, const Fields& fields)
{
  Fields names;
  for (std::string_view rest = head.YadeNames; !rest.empty();)
  {
    const std::size_t cut = std::min(rest.find('_'), rest.size());
    names.push_back(rest.substr(0, cut));
    rest.remove_prefix(std::min(cut + 1, rest.size()));
  }
  const bool attributes = !names.empty() && names.back() == "attrs";
  std::vector<std::string> attributeNames;
  if (attributes)
  {
    names.pop_back();
    const std::size_t named = names.size();
    const std::size_t count = fields.size() > named ? fields.size() - named : 0;
    for (std::size_t i = 0; i < count; ++i)
    {
      attributeNames.push_back("attrs_" + std::to_string(i + 1));
    }
    names.insert(names.end(), attributeNames.begin(), attributeNames.end());
  }
  std::string complaint;
  const auto columns = ColumnsFromNames(names, complaint);
  if (!columns || !complaint.empty())
  {
    throw LineError(head.Row.FirstLine,
      "found rows under #format " +
        Quote(head.YadeNames.data(), head.YadeNames.data() + head.YadeNames.size()) +
        ", expected a format such as x_y_z_r or x_y_z_r_matId");
  }
  return *columns;
}

// The columns that a comment names, when there are as many as in a row. Throws when there are not
// and a diameter is among them, which would pass as a radius.
bool ColumnsFromComment(const Head& head, const Fields& fields, std::vector<Column>& columns)
{
  if (!head.Comment.Begin)
  {
    return false;
  }
  const Fields names = NamesOfComment(head.Comment.Begin);
  std::string complaint;
  auto found = ColumnsFromNames(names, complaint);
  if (complaint.empty() && names.size() == fields.size())
  {
    columns = std::move(*found);
    return true;
  }
  if (std::any_of(found->begin(), found->end(),
        [](const Column& column) { return column.Role == ColumnRole::Diameter; }))
  {
    throw LineError(head.Comment.FirstLine,
      "found a diameter among the " + std::to_string(names.size()) + " names " +
        Quote(SkipBlanks(head.Comment.Begin, head.Comment.End), head.Comment.End) +
        " over rows of " + std::to_string(fields.size()) +
        " columns, expected a name for each column");
  }
  return false;
}

void DetectCsv(const Head& head, TableLayout& layout, TextRange& text)
{
  if (const char delimiter = FindDelimiter(head.Row, ";\t,"))
  {
    layout.Between = Separators::Strict(delimiter);
  }
  const Fields fields = layout.Between.Split(head.Row.Begin);
  const bool numbers = !fields.empty() &&
    std::all_of(fields.begin(), fields.end(), [](auto f) { return IsNumber(f); });
  if (numbers && ColumnsFromComment(head, fields, layout.Columns))
  {
    return;
  }
  layout.Columns = ColumnsFromHeader(head.Row, layout.Between);
  text = { SkipLineEnd(head.Row.End, text.End), text.End, head.Row.FirstLine + 1 };
  MarkTextColumns(layout, FindHead(text).Row.Begin);
}

void DetectPlain(Format format, const Head& head, TableLayout& layout, TextRange& text)
{
  const Fields fields = layout.Between.Split(head.Row.Begin);
  std::string complaint;
  if (ColumnsFromNames(fields, complaint))
  {
    // A header with delimiters is that of a CSV file by another name.
    if (const char delimiter = FindDelimiter(head.Row, ";,"))
    {
      layout.Between = Separators::Strict(delimiter);
    }
    layout.Columns = ColumnsFromHeader(head.Row, layout.Between);
    text = { SkipLineEnd(head.Row.End, text.End), text.End, head.Row.FirstLine + 1 };
    MarkTextColumns(layout, FindHead(text).Row.Begin);
    return;
  }
  if (HasDecimalCommas(head.Row))
  {
    throw LineError(head.Row.FirstLine,
      "found what looks like decimal commas in " + Quote(head.Row.Begin, head.Row.End) +
        ", expected decimal points");
  }
  if (!ColumnsFromComment(head, fields, layout.Columns))
  {
    layout.Columns = !head.YadeNames.empty() ? ColumnsOfYade(head, fields)
      : format == Format::Xyzr               ? LastFourNumeric(head, fields)
                                             : FirstFour(head, fields);
  }
  MarkTextColumns(layout, head.Row.Begin);
}
}

//------------------------------------------------------------------------------
TableLayout DetectTable(Format format, TextRange& text)
{
  const Head head = FindHead(text);
  TableLayout layout;
  if (format == Format::Csv)
  {
    DetectCsv(head, layout, text);
  }
  else
  {
    DetectPlain(format, head, layout, text);
  }
  layout.Expected = DescribeColumns(layout.Columns);
  return layout;
}
}
