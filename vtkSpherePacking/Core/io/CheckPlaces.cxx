// SPDX-License-Identifier: BSD-3-Clause
#include "io/CheckPlaces.h"

#include "io/NamelessColumns.h"
#include "io/Number.h"
#include "io/PackingFileError.h"
#include "io/Separators.h"
#include "io/TableHead.h"
#include "io/TableRows.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

namespace spherepacking
{
namespace
{
using Fields = std::vector<std::string_view>;

[[noreturn]] void ThrowIds(
  const std::string& found, const TableLayout& layout, const TextRange& row)
{
  throw LineError(row.FirstLine,
    "found " + found + " in the first column of " + std::to_string(layout.Columns.size()) +
      ", which may be ids rather than x, in " + Quote(row.Begin, row.End) + ", expected " +
      ColumnsHint);
}

// Throws if the first column has only whole numbers without sign and point, beside y or z with a
// point somewhere, or, where nobody says that x comes first, no two of them the same.
void CheckFirstColumn(const TextRange& text, const TableLayout& layout)
{
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
    ThrowIds("whole numbers", layout, first);
  }
}

// Throws if x numbers eight rows or more, which are not in a line along x, or three or more in
// turn, beside y or z that are not whole. NumPy's savetxt writes ids with a point, as all numbers.
template <typename Real>
void CheckNumbers(const TextRange& text, const TableLayout& layout, const PackingArrays& arrays)
{
  const vtkIdType count = arrays.GetCount();
  const Real* const centers = arrays.Centers<Real>();
  std::vector<bool> seen(count + 1);
  bool line = true;
  bool inTurn = true;
  bool fractions = false;
  for (vtkIdType i = 0; i < count; ++i)
  {
    const Real x = centers[3 * i];
    if (!(x >= 0 && x <= count) || x != std::floor(x) || seen[static_cast<std::size_t>(x)])
    {
      return;
    }
    seen[static_cast<std::size_t>(x)] = true;
    line &= centers[3 * i + 1] == centers[1] && centers[3 * i + 2] == centers[2];
    inTurn &= x == centers[0] + Real(i);
    fractions |= std::floor(centers[3 * i + 1]) != centers[3 * i + 1] ||
      std::floor(centers[3 * i + 2]) != centers[3 * i + 2];
  }
  const bool enough = count >= 8 || (count >= 3 && inTurn && fractions);
  if (enough && !line && (!seen[0] || !seen[count]))
  {
    ThrowIds("the numbers of the rows", layout, FindRow(text));
  }
}

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

// Throws if the first row holds the number of the others before or behind three lengths or six
// bounds of a box that they lie in.
void CheckFirstRow(const TextRange& text, const PackingArrays& arrays)
{
  const TextRange row = FindRow(text);
  const Fields fields = Separators::Liberal().Split(row.Begin);
  const std::string count = std::to_string(arrays.GetCount() - 1);
  if (arrays.GetCount() < 2 || fields.size() > 7 ||
    (fields.front() != count && fields.back() != count))
  {
    return;
  }
  std::vector<double> numbers(fields.size());
  for (std::size_t i = 0; i < fields.size(); ++i)
  {
    ParseNumber(fields[i].data(), fields[i].data() + fields[i].size(), numbers[i]);
  }
  std::vector<Bounds> boxes;
  if (fields.front() == count)
  {
    boxes = BoxesOf({ numbers.begin() + 1, numbers.end() });
  }
  if (fields.back() == count)
  {
    const auto behind = BoxesOf({ numbers.begin(), numbers.end() - 1 });
    boxes.insert(boxes.end(), behind.begin(), behind.end());
  }
  for (const Bounds& box : boxes)
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

//------------------------------------------------------------------------------
void CheckPlaces(const TextRange& text, const TableLayout& layout, const PackingArrays& arrays)
{
  if (layout.Named == Naming::All || layout.Columns[0].Role != ColumnRole::X)
  {
    return;
  }
  if (layout.Columns.size() > 4 || layout.Named == Naming::FourAfterWords)
  {
    CheckFirstColumn(text, layout);
    arrays.IsSingle() ? CheckNumbers<float>(text, layout, arrays)
                      : CheckNumbers<double>(text, layout, arrays);
  }
  CheckFirstRow(text, arrays);
}
}
