// SPDX-License-Identifier: BSD-3-Clause
#include "io/NamelessColumns.h"

#include "io/Number.h"
#include "io/PackingFileError.h"
#include "io/Separators.h"
#include "io/TextChunks.h"

#include <algorithm>
#include <charconv>
#include <string>
#include <string_view>

namespace spherepacking
{
const char* const ColumnsHint = "columns=\"id x y z r\" (--columns) to say what they are";

namespace
{
using Fields = std::vector<std::string_view>;

bool IsWhole(std::string_view field)
{
  return !field.empty() && field.find_first_not_of("0123456789") == field.npos;
}

// Calls `look(row)` for the rows of a text, until it returns false.
template <typename Look>
void ForRows(const TextRange& text, const Look& look)
{
  LineFinder find(text.End);
  vtkIdType line = text.FirstLine;
  for (const char* p = text.Begin; p != text.End; ++line)
  {
    const char* const end = find(p);
    if (IsRow(RowKind::Data, p, end) && !look(TextRange{ SkipBlanks(p, end), end, line }))
    {
      return;
    }
    p = SkipLineEnd(end, text.End);
  }
}

// Numbered columns, but for x, y, z and radius, which begin at `first`.
std::vector<Column> SphereAt(std::size_t first, std::size_t count)
{
  std::vector<Column> columns;
  for (std::size_t i = 0; i < count; ++i)
  {
    columns.push_back({ ColumnRole::Extra, "column_" + std::to_string(i + 1) });
  }
  const Column components[4] = { { ColumnRole::X, "x" }, { ColumnRole::Y, "y" },
    { ColumnRole::Z, "z" }, { ColumnRole::Radius, "radius" } };
  for (std::size_t i = 0; i < 4 && first + i < count; ++i)
  {
    columns[first + i] = components[i];
  }
  return columns;
}

[[noreturn]] void ThrowTooFew(const TextRange& row, std::size_t found, const char* kind)
{
  throw LineError(row.FirstLine,
    "found " + std::to_string(found) + kind + (found == 1 ? "column " : "columns ") +
      Quote(row.Begin, row.End) + ", expected at least 4: x y z radius");
}

// The longest run of numbers in a row, the last one of several.
struct Run
{
  std::size_t First = 0;
  std::size_t Count = 0;
};

Run LongestRun(const Fields& fields)
{
  Run longest;
  Run run;
  for (std::size_t i = 0; i < fields.size(); ++i)
  {
    run = IsNumber(fields[i]) ? Run{ run.First, run.Count + 1 } : Run{ i + 1, 0 };
    longest = run.Count >= longest.Count ? run : longest;
  }
  return longest;
}

// Programs put ids before a sphere, or as MSMS flags behind it; whole numbers tell which (M. Sanner
// et al., "Reduced surface: an efficient way to compute molecular surfaces", 1996).
std::vector<Column> ColumnsOfXyzr(const TextRange& text, const TextRange& row, const Fields& fields)
{
  const Run run = LongestRun(fields);
  if (run.Count < 4)
  {
    const auto numeric = std::count_if(fields.begin(), fields.end(), IsNumber);
    ThrowTooFew(row, numeric, " numeric ");
  }
  const std::size_t last = run.First + run.Count - 1;
  if (run.Count == 4)
  {
    return SphereAt(run.First, fields.size());
  }
  constexpr int enough = 10000;
  bool idsFirst = true;
  bool idsLast = true;
  int rows = 0;
  ForRows(text,
    [&](const TextRange& at)
    {
      const Fields here = Separators::Liberal().Split(at.Begin);
      idsFirst &= run.First < here.size() && IsWhole(here[run.First]);
      idsLast &= last < here.size() && IsWhole(here[last]);
      return ++rows < enough && (idsFirst || idsLast);
    });
  if (idsFirst && idsLast)
  {
    throw LineError(row.FirstLine,
      "found " + std::to_string(run.Count) + " numbers in " + Quote(row.Begin, row.End) +
        ", of which the first or the last may be ids, expected " + ColumnsHint);
  }
  return SphereAt(idsLast ? run.First : last - 3, fields.size());
}
}

//------------------------------------------------------------------------------
std::vector<Column> NamelessColumns(
  Format format, const TextRange& text, const TextRange& row, Radii radii)
{
  const Fields fields = Separators::Liberal().Split(row.Begin);
  if (fields.size() == 3 && radii == Radii::Optional)
  {
    return SphereAt(0, 3);
  }
  if (format == Format::Xyzr)
  {
    return ColumnsOfXyzr(text, row, fields);
  }
  if (fields.size() < 4)
  {
    ThrowTooFew(row, fields.size(), " ");
  }
  return SphereAt(0, fields.size());
}

//------------------------------------------------------------------------------
void CheckFirstColumn(const TextRange& text, const TableLayout& layout)
{
  if (layout.Named == Naming::All || layout.Columns.size() <= 4 ||
    layout.Columns[0].Role != ColumnRole::X)
  {
    return;
  }
  std::vector<unsigned long long> values;
  bool onlyWhole = true;
  bool pointBeside = false;
  TextRange first{ nullptr, nullptr, 0 };
  const Separators& between = layout.Between;
  ForRows(text,
    [&](const TextRange& row)
    {
      first = first.Begin ? first : row;
      const char* end = between.FieldEnd(row.Begin);
      unsigned long long value = 0;
      const auto [at, error] = std::from_chars(row.Begin, end, value);
      onlyWhole = error == std::errc() && at == end;
      values.push_back(value);
      for (int i = 0; i < 2 && !pointBeside; ++i)
      {
        const char* const begin =
          between.SkipBlanks(end) + (between.IsDelimiter(*between.SkipBlanks(end)) ? 1 : 0);
        const char* const field = between.SkipBlanks(begin);
        end = between.FieldEnd(field);
        pointBeside =
          std::string_view(field, end - field).find_first_of(".eE") != std::string_view::npos;
      }
      return onlyWhole;
    });
  if (!onlyWhole)
  {
    return;
  }
  std::sort(values.begin(), values.end());
  const bool distinct = layout.Named == Naming::None &&
    std::adjacent_find(values.begin(), values.end()) == values.end();
  if (distinct || pointBeside)
  {
    throw LineError(first.FirstLine,
      "found whole numbers in the first column of " + std::to_string(layout.Columns.size()) +
        ", which may be ids rather than x, in " + Quote(first.Begin, first.End) + ", expected " +
        ColumnsHint);
  }
}

namespace
{
struct Bounds
{
  double Low[3];
  double High[3];
};

// The boxes that numbers after a count may give: three lengths, from a corner or around the middle,
// or six bounds in either order.
std::vector<Bounds> BoxesOf(const std::vector<double>& v)
{
  if (v.size() == 3)
  {
    return { { { 0, 0, 0 }, { v[0], v[1], v[2] } },
      { { -v[0] / 2, -v[1] / 2, -v[2] / 2 }, { v[0] / 2, v[1] / 2, v[2] / 2 } } };
  }
  if (v.size() == 6)
  {
    return { { { v[0], v[2], v[4] }, { v[1], v[3], v[5] } },
      { { v[0], v[1], v[2] }, { v[3], v[4], v[5] } } };
  }
  return {};
}

template <typename Real>
bool LieInBox(const PackingArrays& arrays, const Bounds& box)
{
  const Real* const centers = arrays.Centers<Real>();
  for (vtkIdType i = 1; i < arrays.GetCount(); ++i)
  {
    for (int axis = 0; axis < 3; ++axis)
    {
      const double at = centers[3 * i + axis];
      if (at < box.Low[axis] || at > box.High[axis])
      {
        return false;
      }
    }
  }
  return true;
}
}

//------------------------------------------------------------------------------
void CheckFirstRow(const TextRange& text, const PackingArrays& arrays)
{
  TextRange row{ nullptr, nullptr, 0 };
  ForRows(text,
    [&](const TextRange& first)
    {
      row = first;
      return false;
    });
  const Fields fields = Separators::Liberal().Split(row.Begin);
  const std::string count = std::to_string(arrays.GetCount() - 1);
  if (arrays.GetCount() < 2 || fields[0] != count || fields.size() > 7)
  {
    return;
  }
  std::vector<double> numbers(fields.size() - 1);
  for (std::size_t i = 1; i < fields.size(); ++i)
  {
    ParseNumber(fields[i].data(), fields[i].data() + fields[i].size(), numbers[i - 1]);
  }
  for (const Bounds& box : BoxesOf(numbers))
  {
    if (arrays.IsSingle() ? LieInBox<float>(arrays, box) : LieInBox<double>(arrays, box))
    {
      throw LineError(row.FirstLine,
        "found " + Quote(row.Begin, row.End) + ", which seems to be the number of the " + count +
          " rows that follow and their box, expected rows of spheres alone, or # before it");
    }
  }
}
}
