// SPDX-License-Identifier: BSD-3-Clause
#include "io/TextTable.h"

#include "io/DecimalCommas.h"
#include "io/PackingFileError.h"
#include "io/RowParser.h"

#include <algorithm>
#include <atomic>
#include <memory>
#include <string>
#include <string_view>

namespace spherepacking
{
namespace
{
struct BadRow
{
  const char* Line = nullptr;
  RowFault Fault{};
};

template <typename Parser>
void ParseChunk(const TextChunk& chunk, const Parser& parser, BadRow& bad)
{
  LineFinder find(chunk.End);
  vtkIdType row = chunk.FirstRow;
  for (const char* p = chunk.Begin; p != chunk.End;)
  {
    p = parser.ParsePlainRows(p, chunk.End, row);
    const char* end = p;
    if (p != chunk.End && IsRow(RowKind::Data, p, chunk.End))
    {
      end = parser.Parse(p, row, bad.Fault);
      if (!end)
      {
        bad.Line = p;
        return;
      }
      ++row;
    }
    // Parsing stops at the line end, or at a comment after the numbers.
    p = SkipLineEnd(IsLineEnd(*end) ? end : find(end), chunk.End);
  }
}

const char* LineEndOf(const char* p)
{
  while (!IsLineEnd(*p))
  {
    ++p;
  }
  return p;
}

// Throws if no field of a row is a number, as in titles, units and the empty rows of spreadsheets.
void CheckSomeNumber(vtkIdType line, const TableLayout& layout, const char* begin)
{
  const std::vector<std::string_view> fields = layout.Between.Split(begin);
  const auto isEmpty = [](std::string_view field) { return field.empty(); };
  if (fields.size() > 1 && std::none_of(fields.begin(), fields.end(), IsNumber))
  {
    const bool empty = std::all_of(fields.begin(), fields.end(), isEmpty);
    const char* const end = LineEndOf(begin);
    throw LineError(line,
      "found " + Quote(SkipBlanks(begin, end), end) +
        (empty ? ", a row of empty fields, expected "
               : ", in which no field is a number, expected ") +
        layout.Expected + (empty ? "; delete the row" : "; or # before what is no row"));
  }
}

[[noreturn]] void ThrowColumnCount(vtkIdType line, const TableLayout& layout, const char* begin)
{
  const std::size_t found = layout.Between.Split(begin).size();
  const char* const end = LineEndOf(begin);
  const std::string_view row(begin, end - begin);
  if (found > layout.Columns.size() && HasDecimalCommas(row))
  {
    throw LineError(line,
      "found what looks like decimal commas in " + Quote(SkipBlanks(begin, end), end) +
        ", expected decimal points");
  }
  throw LineError(line,
    "found " + std::to_string(found) + (found == 1 ? " column " : " columns ") +
      Quote(SkipBlanks(begin, end), end) + ", expected " + layout.Expected);
}

[[noreturn]] void ThrowBadRow(const TextChunk& chunk, const TableLayout& layout, const BadRow& bad)
{
  const vtkIdType line = chunk.FirstLine + CountLineEnds(chunk.Begin, bad.Line);
  const RowFault& fault = bad.Fault;
  if (fault.What == RowFault::TooFewColumns || fault.What == RowFault::TooManyColumns)
  {
    ThrowColumnCount(line, layout, bad.Line);
  }
  if (fault.What == RowFault::NotANumber)
  {
    CheckSomeNumber(line, layout, bad.Line);
  }
  const Column& column = layout.Columns[fault.Column];
  // A radius is called so even if the column is called r.
  const std::string name = column.Role == ColumnRole::Radius ? "radius"
    : column.Role == ColumnRole::Diameter                    ? "diameter"
                                                             : column.Name;
  const std::string field = fault.At ? Quote(fault.At, layout.Between.FieldEnd(fault.At))
                                     : "a place in the box that is beyond all numbers";
  const char* expected = fault.What == RowFault::NotANumber ? "a number"
    : fault.What == RowFault::NotFinite                     ? "a finite number"
                                                            : "a number that is not negative";
  const char* const fieldEnd = fault.At ? layout.Between.FieldEnd(fault.At) : nullptr;
  const bool comma = fault.What == RowFault::NotANumber && fault.At &&
    IsDecimalComma(
      layout.Between.Unquote({ fault.At, static_cast<std::size_t>(fieldEnd - fault.At) }));
  throw LineError(line,
    "found " + field + " as " + name + " in column " + std::to_string(fault.Column + 1) +
      (comma ? ", which looks like a decimal comma, expected a number with a point"
             : std::string(", expected ") + expected));
}

template <typename Real, bool Scaled>
void ParseInto(PackingArrays& arrays, const ExtraColumns& extras, const char* textEnd,
  const TableLayout& layout, const std::vector<TextChunk>& chunks, Progress& progress)
{
  const RowParser<Real, Scaled> parser(
    layout, textEnd, arrays.Centers<Real>(), arrays.Radii<Real>(), extras);

  std::vector<BadRow> bad(chunks.size());
  std::atomic<bool> failed{ false };
  const auto throwIfFailed = [&]
  {
    for (std::size_t i = 0; failed && i < bad.size(); ++i)
    {
      if (bad[i].Line)
      {
        ThrowBadRow(chunks[i], layout, bad[i]);
      }
    }
  };
  ForInBatches(
    static_cast<vtkIdType>(chunks.size()), 1, progress,
    [&](vtkIdType first, vtkIdType last)
    {
      for (vtkIdType i = first; i < last; ++i)
      {
        ParseChunk(chunks[i], parser, bad[i]);
        if (bad[i].Line)
        {
          failed = true;
        }
      }
    },
    throwIfFailed);
}
}

//------------------------------------------------------------------------------
TableParser::TableParser(const TableLayout& layout, vtkIdType count, bool single)
  : Rows(layout)
  , Arrays(count, single, HasRadius(layout.Columns))
  , Extras(new ExtraColumns)
{
  const std::size_t columns = layout.Columns.size();
  CheckColumnCount(columns);
  *this->Extras = { std::vector<double*>(columns), std::vector<std::string*>(columns),
    std::make_unique<std::atomic<bool>[]>(columns) };
  for (std::size_t i = 0; i < columns; ++i)
  {
    const Column& column = layout.Columns[i];
    if (column.Role == ColumnRole::Extra)
    {
      this->Extras->Numbers[i] = this->Arrays.AddExtra(column.Name);
    }
    else if (column.Role == ColumnRole::Text)
    {
      this->Extras->Texts[i] = this->Arrays.AddText(column.Name);
    }
    else if (column.Role == ColumnRole::Radius || column.Role == ColumnRole::Diameter)
    {
      this->Arrays.SetRadiusName(column.Name);
    }
  }
}

//------------------------------------------------------------------------------
TableParser::~TableParser() = default;

//------------------------------------------------------------------------------
void TableParser::Parse(
  const char* textEnd, const std::vector<TextChunk>& chunks, Progress& progress)
{
  const bool scaled = this->Rows.Box.has_value();
  const auto parse = this->Arrays.IsSingle()
    ? (scaled ? ParseInto<float, true> : ParseInto<float, false>)
    : (scaled ? ParseInto<double, true> : ParseInto<double, false>);
  parse(this->Arrays, *this->Extras, textEnd, this->Rows, chunks, progress);
}

//------------------------------------------------------------------------------
std::optional<TableLayout> TableParser::LayoutWithText() const
{
  std::optional<TableLayout> layout;
  for (std::size_t i = 0; i < this->Rows.Columns.size(); ++i)
  {
    if (this->Extras->IsText[i])
    {
      if (!layout)
      {
        layout = this->Rows;
      }
      layout->Columns[i].Role = ColumnRole::Text;
    }
  }
  return layout;
}

//------------------------------------------------------------------------------
PackingArrays ParseTable(const char* textEnd, const TableLayout& layout,
  const std::vector<TextChunk>& chunks, bool single, Progress& progress)
{
  std::optional<TableLayout> roles = layout;
  while (true)
  {
    TableParser parser(*roles, CountRows(chunks), single);
    parser.Parse(textEnd, chunks, progress);
    roles = parser.LayoutWithText();
    if (!roles)
    {
      return parser.Take();
    }
  }
}

//------------------------------------------------------------------------------
void CheckNoShortRow(const TextRange& text, const TableLayout& layout)
{
  LineFinder find(text.End);
  vtkIdType line = text.FirstLine;
  for (const char* p = text.Begin; p != text.End; ++line)
  {
    const char* const end = find(p);
    if (IsRow(RowKind::Data, p, end) && layout.Between.Split(p).size() < layout.Columns.size())
    {
      ThrowColumnCount(line, layout, p);
    }
    p = SkipLineEnd(end, text.End);
  }
}

//------------------------------------------------------------------------------
void CheckCount(vtkIdType count, const char* things, vtkIdType line, vtkIdType rows)
{
  if (rows != count)
  {
    throw LineError(line,
      "found " + std::to_string(count) + " as the number of " + things + ", but " +
        std::to_string(rows) + " lines of " + things + " follow, expected as many");
  }
}
}
