// SPDX-License-Identifier: BSD-3-Clause
#include "io/TextTable.h"

#include "io/PackingFileError.h"
#include "io/RowParser.h"

#include <algorithm>
#include <memory>
#include <string_view>

namespace spherepacking
{
namespace
{
struct BadRow
{
  const char* Line = nullptr;
  const char* Row = nullptr; // where parsing began, which is not the line for an ATOM record
  RowFault Fault{};
};

// Whether [begin, end) has the fields that come first in an ATOM record: ATOM, number, name,
// residue and number of the residue, at least. If one is missing, the last fields are not those
// expected.
bool HasLeadingFields(const TableLayout& layout, const char* begin, const char* end)
{
  constexpr std::size_t minimum = 5;
  std::size_t count = 0;
  std::string_view last;
  for (const char* p = SkipBlanks(begin, end); p != end; p = SkipBlanks(p, end))
  {
    const char* next = std::min(layout.Between.FieldEnd(p), end);
    next += next == p; // a lone separator
    last = std::string_view(p, next - p);
    p = next;
    ++count;
  }
  // With five, the last is the residue's number, and not the letter of a chain without digits.
  return count > minimum || (count == minimum && last.find_first_of("0123456789") != last.npos);
}

// Where the layout's columns begin in an ATOM record, which has them last, after a varying number
// of others (T. Dolinsky et al., "PDB2PQR: an automated pipeline for the setup of
// Poisson-Boltzmann electrostatics calculations", 2004).
const char* FirstField(const TableLayout& layout, const char* begin, const char* end)
{
  const char* p = end;
  for (std::size_t field = 0; field < layout.Columns.size(); ++field)
  {
    while (p != begin && IsBlank(p[-1]))
    {
      --p;
    }
    while (p != begin && !IsBlank(p[-1]))
    {
      --p;
    }
  }
  return p;
}

template <typename Parser>
void ParseChunk(
  const TextChunk& chunk, const TableLayout& layout, const Parser& parser, BadRow& bad)
{
  LineFinder find(chunk.End);
  vtkIdType row = chunk.FirstRow;
  for (const char* p = chunk.Begin; p != chunk.End;)
  {
    const char* end = p;
    if (IsRow(layout.Rows, p, chunk.End))
    {
      const bool atom = layout.Rows == RowKind::Atom;
      const char* first = atom ? FirstField(layout, p, find(p)) : p;
      if (atom && !HasLeadingFields(layout, p, first))
      {
        bad = { p, p, { RowFault::TooFewColumns, 0, p } };
        return;
      }
      end = parser.Parse(first, row, bad.Fault);
      if (!end)
      {
        bad.Line = p;
        bad.Row = first;
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
    const std::size_t found = layout.Between.Split(bad.Row).size();
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
  // The columns of an ATOM record are counted from its end, so a number would mislead.
  const std::string where = layout.Rows == RowKind::Atom
    ? " (" + layout.Expected + ")"
    : " in column " + std::to_string(fault.Column + 1);
  throw LineError(line, "found " + field + " as " + name + where + ", expected " + expected);
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
PackingArrays ParseTable(const char* textEnd, const TableLayout& layout,
  const std::vector<TextChunk>& chunks, bool single, Progress& progress)
{
  const bool scaled = layout.Box.has_value();
  const auto parse = single ? (scaled ? ParseInto<float, true> : ParseInto<float, false>)
                            : (scaled ? ParseInto<double, true> : ParseInto<double, false>);
  const bool hasRadii =
    std::any_of(layout.Columns.begin(), layout.Columns.end(), [](const Column& column)
      { return column.Role == ColumnRole::Radius || column.Role == ColumnRole::Diameter; });
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
