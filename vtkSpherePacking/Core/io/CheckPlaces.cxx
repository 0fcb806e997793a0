// SPDX-License-Identifier: BSD-3-Clause
#include "io/CheckPlaces.h"

#include "io/NamelessColumns.h"
#include "io/Number.h"
#include "io/PackingFileError.h"
#include "io/Separators.h"
#include "io/TableHead.h"
#include "io/TableRows.h"

#include <algorithm>
#include <array>
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

// How to say that the first of `columns` is `name`, and how that it is x.
std::string BothHints(const std::string& name, const std::vector<Column>& columns)
{
  constexpr std::size_t most = 12;
  const std::string sphere = HasRadius(columns) ? "x y z r" : "x y z";
  const std::size_t named = HasRadius(columns) ? 4 : 3;
  const auto names = [&](const std::string& first, std::size_t count)
  {
    std::string text = "columns=\"" + first + sphere;
    for (std::size_t i = count; i < std::min(columns.size(), most); ++i)
    {
      text += " -";
    }
    return text + (columns.size() > most ? " ...\"" : "\"");
  };
  return names(name + ' ', named + 1) + " or " + names("", named) + " (--columns) to say which";
}

[[noreturn]] void ThrowIds(
  const std::string& found, const TableLayout& layout, const TextRange& row)
{
  const bool noRadius = layout.Columns.size() == 4 && !HasRadius(layout.Columns);
  throw LineError(row.FirstLine,
    "found " + found + " in the first column of " + std::to_string(layout.Columns.size()) +
      ", which may be ids rather than x, in " + Quote(row.Begin, row.End) + ", expected " +
      (noRadius ? BothHints("id", layout.Columns) : ColumnsHint));
}

bool HasPoint(std::string_view field)
{
  return field.find_first_of(".eE") != field.npos;
}

/// What rows say of the first column: all, or those up to one in which it is no id.
class FirstColumn
{
public:
  FirstColumn(const TextRange& text, const Separators& between)
  {
    ForRows(text,
      [&](const TextRange& row)
      {
        this->First = this->First.Begin ? this->First : row;
        this->MayBeIds = this->Add(row.Begin, between);
        return this->MayBeIds;
      });
    std::sort(this->Values.begin(), this->Values.end());
  }

  bool IsDistinct() const
  {
    return std::adjacent_find(this->Values.begin(), this->Values.end()) == this->Values.end();
  }

  // Whether y, z and radius are the same in several rows. Ids would leave all spheres in one place.
  bool IsRow() const { return this->Values.size() > 1 && this->Repeats; }

  TextRange First{ nullptr, nullptr, 0 };
  bool MayBeIds = true;            ///< whole numbers without sign, all of them with a point or none
  bool Points = false;             ///< they have one
  bool PointsBeside = false;       ///< numbers in the columns of y or z have
  bool PointsEverywhere = true;    ///< all numbers of other columns have
  std::array<bool, 3> Fractions{}; ///< in which of y, z and radius some number is not whole

private:
  // Looks at the row at `p`. False if it shows that the column holds no ids.
  bool Add(const char* p, const Separators& between)
  {
    const bool isFirstRow = this->Values.empty();
    p = between.SkipBlanks(p);
    for (std::size_t i = 0; !between.EndsLine(*p) && (i < 4 || this->PointsEverywhere); ++i)
    {
      const char* const end = between.FieldEnd(p);
      const std::string_view field = between.Unquote({ p, static_cast<std::size_t>(end - p) });
      const char* const fieldEnd = field.data() + field.size();
      double value = 0;
      const bool isNumber = ParseNumber(field.data(), fieldEnd, value) == fieldEnd;
      const bool points = HasPoint(field);
      const bool isWhole = value == std::floor(value);
      if (i == 0)
      {
        const bool digit = !field.empty() && field[0] >= '0' && field[0] <= '9';
        if (!isNumber || !digit || !isWhole || (!isFirstRow && points != this->Points))
        {
          return false;
        }
        this->Points = points;
        this->Values.push_back(value);
      }
      else if (i < 4)
      {
        this->PointsBeside |= i < 3 && points;
        this->Fractions[i - 1] |= !isWhole;
        this->Repeats &= isFirstRow || value == this->Place[i - 1];
        this->Place[i - 1] = value;
      }
      this->PointsEverywhere &= i == 0 || points || !isNumber;
      p = between.SkipBlanks(end);
      p = between.IsDelimiter(*p) ? between.SkipBlanks(p + 1) : p;
    }
    return true;
  }

  std::vector<double> Values;
  std::array<double, 3> Place{};
  bool Repeats = true;
};

// Throws if the first column may hold ids or kinds. Where it has points, as all numbers by NumPy's
// savetxt, and another number has none, whoever wrote the rows tells whole numbers from others, so
// that it is x. Whole numbers in y and z, too, are those of a grid if the radius behind them is
// none.
void CheckFirstColumn(const TextRange& text, const TableLayout& layout)
{
  const FirstColumn column(text, layout.Between);
  const bool nobodySays = layout.Named == Naming::None;
  const bool fractionsBeside = column.Fractions[0] || column.Fractions[1];
  const bool grid = !fractionsBeside && column.Fractions[2] && !column.IsDistinct();
  const bool certain = column.Points
    ? !nobodySays || !column.PointsEverywhere || column.IsRow() || grid
    : !column.PointsBeside && (!nobodySays || grid);
  if (column.MayBeIds && !certain)
  {
    ThrowIds("whole numbers", layout, column.First);
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

// Throws if x never falls and a third of the rows or more repeat it, as the times of a simulation
// do. Whole numbers are looked at as ids are, no time is negative, and times would not leave all
// spheres in one place. The price is a lattice that is sorted by x.
template <typename Real>
void CheckTimes(const TextRange& text, const TableLayout& layout, const PackingArrays& arrays)
{
  const vtkIdType count = arrays.GetCount();
  const Real* const centers = arrays.Centers<Real>();
  vtkIdType repeated = 0;
  const Real* const radii = HasRadius(layout.Columns) ? arrays.Radii<Real>() : nullptr;
  bool whole = true;
  bool onePlace = radii != nullptr;
  for (vtkIdType i = 0; i < count; ++i)
  {
    const Real x = centers[3 * i];
    onePlace = onePlace && radii[i] == radii[0] && centers[3 * i + 1] == centers[1] &&
      centers[3 * i + 2] == centers[2];
    const Real before = i > 0 ? centers[3 * (i - 1)] : Real(0);
    if (!(x >= before))
    {
      return;
    }
    repeated += i > 0 && x == before ? 1 : 0;
    whole &= x == std::floor(x);
  }
  if (!whole && !onePlace && repeated > 0 && 3 * repeated >= count)
  {
    const TextRange row = FindRow(text);
    throw LineError(row.FirstLine,
      "found numbers that repeat and never fall in the first column of " +
        std::to_string(layout.Columns.size()) + ", which may be times rather than x, in " +
        Quote(row.Begin, row.End) + ", expected " + BothHints("time", layout.Columns));
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
          " rows that follow and their box, expected rows of spheres alone, # before it, or " +
          (fields.size() == 4 ? HintFor(4) + ", if it is a sphere" : HintFor(fields.size())));
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
  const bool four = layout.Columns.size() == 4;
  if (layout.Columns.size() > 4 || (four && !HasRadius(layout.Columns)) ||
    layout.Named == Naming::FourAfterWords)
  {
    CheckFirstColumn(text, layout);
    arrays.IsSingle() ? CheckNumbers<float>(text, layout, arrays)
                      : CheckNumbers<double>(text, layout, arrays);
    if (layout.Named == Naming::None)
    {
      arrays.IsSingle() ? CheckTimes<float>(text, layout, arrays)
                        : CheckTimes<double>(text, layout, arrays);
    }
  }
  CheckFirstRow(text, arrays);
}
}
