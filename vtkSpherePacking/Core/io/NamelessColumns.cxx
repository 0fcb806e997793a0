// SPDX-License-Identifier: BSD-3-Clause
#include "io/NamelessColumns.h"

#include "io/PackingFileError.h"
#include "io/Separators.h"
#include "io/TableRows.h"

#include <algorithm>
#include <string>
#include <string_view>

namespace spherepacking
{
const char* const ColumnsHint = "columns=\"id x y z r\" (--columns) to say what they are";

namespace
{
using Fields = std::vector<std::string_view>;

// Numbered columns, but for x, y, z and radius, which begin at `first`. Who gives radii says that
// the fourth, which nobody has named, need not be one.
std::vector<Column> SphereAt(std::size_t first, std::size_t count, Radii radii)
{
  std::vector<Column> columns;
  for (std::size_t i = 0; i < count; ++i)
  {
    columns.push_back({ ColumnRole::Extra, "column_" + std::to_string(i + 1) });
  }
  const Column components[4] = { { ColumnRole::X, "x" }, { ColumnRole::Y, "y" },
    { ColumnRole::Z, "z" }, { ColumnRole::Radius, "radius" } };
  const std::size_t certain = radii == Radii::Required ? 4 : 3;
  for (std::size_t i = 0; i < certain && first + i < count; ++i)
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
    return SphereAt(run.First, fields.size(), Radii::Required);
  }
  constexpr int enough = 10000;
  bool idsFirst = true;
  bool idsLast = true;
  int rows = 0;
  ForRows(text,
    [&](const TextRange& at)
    {
      const Fields here = Separators::Liberal().Split(at.Begin);
      const auto areWhole = [&](std::size_t first, std::size_t end)
      {
        return end <= here.size() && std::all_of(here.begin() + first, here.begin() + end, IsWhole);
      };
      idsFirst = idsFirst && areWhole(run.First, last - 3);
      idsLast = idsLast && areWhole(run.First + 4, last + 1);
      return ++rows < enough && (idsFirst || idsLast);
    });
  if (idsFirst == idsLast)
  {
    throw LineError(row.FirstLine,
      "found " + std::to_string(run.Count) + " numbers in " + Quote(row.Begin, row.End) +
        (idsFirst ? ", of which the first or the last may be ids"
                  : ", of which neither the first nor the last are ids for certain") +
        ", expected " + ColumnsHint);
  }
  return SphereAt(idsLast ? run.First : last - 3, fields.size(), Radii::Required);
}
}

//------------------------------------------------------------------------------
std::string HintFor(std::size_t count)
{
  return count == 4 ? "columns=\"x y z r\" (--columns) or the like to say what they are"
                    : ColumnsHint;
}

//------------------------------------------------------------------------------
std::vector<Column> NamelessColumns(
  Format format, const TextRange& text, const TextRange& row, Radii radii)
{
  const Fields fields = Separators::Liberal().Split(row.Begin);
  if (fields.size() == 3 && radii == Radii::Optional)
  {
    return SphereAt(0, 3, radii);
  }
  if (format == Format::Xyzr)
  {
    return ColumnsOfXyzr(text, row, fields); // the extension names the radius
  }
  if (fields.size() < 4)
  {
    ThrowTooFew(row, fields.size(), " ");
  }
  return SphereAt(0, fields.size(), radii);
}
}
