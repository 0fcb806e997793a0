// SPDX-License-Identifier: BSD-3-Clause
#include "io/TextTable.h"

#include "io/PackingFileError.h"
#include "io/RowParser.h"

#include <algorithm>
#include <memory>

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
void ParseChunk(
  const TextChunk& chunk, const TableLayout& layout, const Parser& parser, BadRow& bad)
{
  LineFinder find(chunk.End);
  vtkIdType row = chunk.FirstRow;
  for (const char* p = chunk.Begin; p != chunk.End;)
  {
    p = parser.ParsePlainRows(p, chunk.End, row);
    const char* end = p;
    if (p != chunk.End && IsRow(layout.Rows, p, chunk.End))
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

[[noreturn]] void ThrowBadRow(const TextChunk& chunk, const TableLayout& layout, const BadRow& bad)
{
  const vtkIdType line = chunk.FirstLine + CountLineEnds(chunk.Begin, bad.Line);
  const RowFault& fault = bad.Fault;
  if (fault.What == RowFault::TooFewColumns || fault.What == RowFault::TooManyColumns)
  {
    const std::size_t found = layout.Between.Split(bad.Line).size();
    const char* end = bad.Line;
    while (!IsLineEnd(*end))
    {
      ++end;
    }
    throw LineError(line,
      "found " + std::to_string(found) + (found == 1 ? " column " : " columns ") +
        Quote(SkipBlanks(bad.Line, end), end) + ", expected " + layout.Expected);
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
  throw LineError(line,
    "found " + field + " as " + name + " in column " + std::to_string(fault.Column + 1) +
      ", expected " + expected);
}

// Parses the rows into arrays. Returns whether a column of numbers turned out to be text, whose
// role in `layout` is that from then on.
template <typename Real, bool Scaled>
bool ParseInto(PackingArrays& arrays, const char* textEnd, TableLayout& layout,
  const std::vector<TextChunk>& chunks, Progress& progress)
{
  const std::size_t columns = layout.Columns.size();
  ExtraColumns extras{ std::vector<double*>(columns), std::vector<std::string*>(columns),
    std::make_unique<std::atomic<bool>[]>(columns) };
  for (std::size_t i = 0; i < columns; ++i)
  {
    const Column& column = layout.Columns[i];
    if (column.Role == ColumnRole::Extra)
    {
      extras.Numbers[i] = arrays.AddExtra(column.Name);
    }
    else if (column.Role == ColumnRole::Text)
    {
      extras.Texts[i] = arrays.AddText(column.Name);
    }
  }
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
        ParseChunk(chunks[i], layout, parser, bad[i]);
        if (bad[i].Line)
        {
          failed = true;
        }
      }
    },
    throwIfFailed);

  bool turned = false;
  for (std::size_t i = 0; i < columns; ++i)
  {
    if (extras.IsText[i])
    {
      layout.Columns[i].Role = ColumnRole::Text;
      turned = true;
    }
  }
  return turned;
}
}

//------------------------------------------------------------------------------
void CheckCount(
  vtkIdType count, const std::string& things, vtkIdType line, const std::vector<TextChunk>& chunks)
{
  if (const vtkIdType rows = CountRows(chunks); rows != count)
  {
    throw LineError(line,
      "found " + std::to_string(count) + " as the number of " + things + ", but " +
        std::to_string(rows) + " lines of " + things + " follow, expected as many");
  }
}

//------------------------------------------------------------------------------
void CheckNotCut(const TextRange& rows)
{
  const char* last = rows.End;
  if (last == rows.Begin || IsLineEnd(last[-1]))
  {
    return;
  }
  while (last != rows.Begin && !IsLineEnd(last[-1]))
  {
    --last;
  }
  throw LineError(rows.FirstLine + CountLineEnds(rows.Begin, last),
    "found the end of the file within the row " + Quote(last, rows.End) +
      ", expected a line end after every row");
}

//------------------------------------------------------------------------------
PackingArrays ParseTable(const char* textEnd, const TableLayout& layout,
  const std::vector<TextChunk>& chunks, bool single, Progress& progress)
{
  const bool scaled = layout.Box.has_value();
  const auto parse = single ? (scaled ? ParseInto<float, true> : ParseInto<float, false>)
                            : (scaled ? ParseInto<double, true> : ParseInto<double, false>);
  const bool hasRadii = HasRadius(layout.Columns);
  TableLayout roles = layout;
  {
    PackingArrays arrays(CountRows(chunks), single, hasRadii);
    if (!parse(arrays, textEnd, roles, chunks, progress))
    {
      return arrays;
    }
  }
  // Again, since the text of rows before the first that was no number is gone.
  PackingArrays arrays(CountRows(chunks), single, hasRadii);
  parse(arrays, textEnd, roles, chunks, progress);
  return arrays;
}
}
