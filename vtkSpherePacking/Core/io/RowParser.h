// SPDX-License-Identifier: BSD-3-Clause
#ifndef RowParser_h
#define RowParser_h

#include "base/Dispatch.h"
#include "io/Number.h"
#include "bridge/PrintableText.h"
#include "io/ShortRow.h"
#include "io/ShortRows.h"
#include "io/TableLayout.h"

#include <algorithm>
#include <atomic>
#include <cmath>
#include <cstddef>
#include <limits>
#include <memory>
#include <string>
#include <vector>

namespace spherepacking
{
/// What is wrong with a row, and in which column.
struct RowFault
{
  enum Kind : unsigned char
  {
    TooFewColumns,
    TooManyColumns,
    NotANumber,
    NotFinite,
    Negative
  };
  Kind What;
  int Column;     ///< from 0
  const char* At; ///< where the offending field begins; null if no field alone is wrong
};

/// Where the further columns of a table go. Each has an element per column of the table.
struct ExtraColumns
{
  std::vector<double*> Numbers;    ///< null where the role is not Extra
  std::vector<std::string*> Texts; ///< null where the role is not Text
  /// Set if a field of a column whose role is Extra is no number.
  std::unique_ptr<std::atomic<bool>[]> IsText;
};

/**
 * Parses rows of one layout into arrays. `Real` is the precision of centres and radii; `Scaled`
 * says that coordinates are fractions of the layout's box.
 */
template <typename Real, bool Scaled>
class RowParser
{
public:
  /// `radii` is null if no column holds any.
  RowParser(const TableLayout& layout, const char* textEnd, Real* centers, Real* radii,
    const ExtraColumns& extras)
    : Layout(layout)
    , Between(layout.Between)
    , TextEnd(textEnd)
    , Centers(centers)
    , Radii(radii)
    , Extras(extras)
  {
    for (const Column& column : layout.Columns)
    {
      this->Roles.push_back(column.Role);
    }
    this->IsPlain = !Scaled &&
      this->Roles ==
        std::vector<ColumnRole>{ ColumnRole::X, ColumnRole::Y, ColumnRole::Z, ColumnRole::Radius };
  }

  /// Parses lines from `p` on into rows `row` and so on of the arrays, moving `row` on, as long as
  /// they are of the most common form; returns the first that is not. `end` is the end of a line.
  const char* ParsePlainRows(const char* p, const char* end, vtkIdType& row) const
  {
#if defined(SPHEREPACKING_HAS_AVX2)
    if (this->IsPlain && HasAvx2())
    {
      long long count = 0;
      p = ParseShortRowsAvx2(p, end, this->Centers + 3 * row, this->Radii + row, count);
      row += count;
    }
#endif
    return p;
  }

  /// Parses the line at `p` into row `row` of the arrays. Returns the line end, or null with
  /// `fault` set.
  const char* Parse(const char* p, vtkIdType row, RowFault& fault) const
  {
    if (const char* const end = this->IsPlain ? this->ParsePlain(p, row) : nullptr)
    {
      return end;
    }
    const int count = static_cast<int>(this->Roles.size());
    Coordinate center[3] = {}; // two-dimensional rows have no z
    p = this->Between.SkipBlanks(p);
    for (int column = 0; column < count; ++column)
    {
      const char* const field = p;
      // After a strict delimiter, even nothing is a field.
      if (this->Between.EndsLine(*p) && !(this->Between.IsStrict() && column == count - 1))
      {
        fault = { RowFault::TooFewColumns, column, p };
        return nullptr;
      }
      const ColumnRole role = this->Roles[column];
      if (role <= ColumnRole::Z)
      {
        p = this->ParseFinite(p, column, center[static_cast<int>(role)], fault);
      }
      else if (role <= ColumnRole::Diameter)
      {
        p = this->ParseRadius(p, column, this->Radii[row], fault);
      }
      else
      {
        p = role == ColumnRole::Extra ? this->ParseExtra(p, column, row)
          : role == ColumnRole::Text  ? this->StoreText(p, column, row)
                                      : this->SkipField(p);
      }
      if (!p)
      {
        return nullptr;
      }
      p = this->Between.SkipBlanks(p);
      if (this->Between.IsDelimiter(*p))
      {
        p = this->Between.SkipBlanks(p + 1);
      }
      else if (this->Between.IsStrict() && !this->Between.EndsLine(*p))
      {
        fault = { RowFault::NotANumber, column, field };
        return nullptr;
      }
      else if (this->Between.IsStrict() && column + 1 < count)
      {
        fault = { RowFault::TooFewColumns, column + 1, p };
        return nullptr;
      }
    }
    if (!this->Between.EndsLine(*p))
    {
      fault = { RowFault::TooManyColumns, count, p };
      return nullptr;
    }
    return this->StoreCenter(center, row, fault) ? p : nullptr;
  }

private:
  // A fast path for the most common row: x y z r, separated by a space each. Null if the row is
  // anything else, valid or not, which is for the general path to decide.
  const char* ParsePlain(const char* p, vtkIdType row) const
  {
    Real values[4];
    const char* end = ParseShortRow(p, this->TextEnd, values);
    end = end ? end : this->ParseSpaced(p, values);
    if (!end || std::signbit(values[3]))
    {
      return nullptr;
    }
    std::copy_n(values, 3, this->Centers + 3 * row);
    this->Radii[row] = values[3];
    return end;
  }

  // Parses four finite numbers, separated by a space each, and nothing else. Returns the line end.
  const char* ParseSpaced(const char* p, Real (&values)[4]) const
  {
    for (Real& value : values)
    {
      p = ParseNumber(p, this->TextEnd, value);
      if (!p || (*p != ' ' && !IsLineEnd(*p)) ||
        !(std::abs(value) <= std::numeric_limits<Real>::max()))
      {
        return nullptr;
      }
      p += *p == ' ';
    }
    return IsLineEnd(*p) ? p : nullptr;
  }

  // Fractions are taken to coordinates in double precision, before they are rounded to Real.
  using Coordinate = std::conditional_t<Scaled, double, Real>;

  // Parses a field that is one number, quoted or not. Null if it is anything else.
  template <typename T>
  const char* ParseField(const char* p, T& value) const
  {
    const bool quoted = this->Between.IsStrict() && *p == '"';
    p = ParseNumber(p + quoted, this->TextEnd, value);
    if (p && quoted)
    {
      p = *p == '"' ? p + 1 : nullptr;
    }
    return p && this->Between.EndsNumber(*p) ? p : nullptr;
  }

  template <typename T>
  const char* ParseFinite(const char* p, int column, T& value, RowFault& fault) const
  {
    const char* const end = this->ParseField(p, value);
    if (!end)
    {
      fault = { RowFault::NotANumber, column, p };
      return nullptr;
    }
    if (!(std::abs(value) <= std::numeric_limits<T>::max()))
    {
      fault = { RowFault::NotFinite, column, p };
      return nullptr;
    }
    return end;
  }

  const char* ParseRadius(const char* p, int column, Real& radius, RowFault& fault) const
  {
    const char* const end = this->ParseFinite(p, column, radius, fault);
    if (end && IsNegative(p, end, radius))
    {
      fault = { RowFault::Negative, column, p };
      return nullptr;
    }
    if (end && this->Roles[column] == ColumnRole::Diameter)
    {
      radius *= Real(0.5);
    }
    return end;
  }

  // An empty field is NaN; any other that is no number makes the whole column text, and so does an
  // integer that no double is.
  const char* ParseExtra(const char* p, int column, vtkIdType row) const
  {
    double& value = this->Extras.Numbers[column][row];
    const char* end = this->ParseField(p, value);
    if (end && IsAsWritten(p, end, value))
    {
      return end;
    }
    value = std::numeric_limits<double>::quiet_NaN();
    end = this->SkipField(p);
    if (end != p)
    {
      this->Extras.IsText[column].store(true, std::memory_order_relaxed);
    }
    return end;
  }

  const char* StoreText(const char* p, int column, vtkIdType row) const
  {
    const char* const end = this->SkipField(p);
    const std::string_view field(p, end - p);
    const std::string_view plain = this->Between.Unquote(field);
    std::string& text = this->Extras.Texts[column][row];
    text = PrintableText(plain);
    if (plain.size() != field.size())
    {
      for (std::size_t at = text.find("\"\""); at != text.npos; at = text.find("\"\"", at + 1))
      {
        text.erase(at, 1);
      }
    }
    return end;
  }

  const char* SkipField(const char* p) const { return this->Between.FieldEnd(p); }

  bool StoreCenter(const Coordinate (&center)[3], vtkIdType row, RowFault& fault) const
  {
    Real* const to = this->Centers + 3 * row;
    for (int axis = 0; axis < 3; ++axis)
    {
      if constexpr (Scaled)
      {
        const SimulationCell& box = *this->Layout.Box;
        to[axis] = static_cast<Real>(box.Origin[axis] + center[0] * box.Vectors[0][axis] +
          center[1] * box.Vectors[1][axis] + center[2] * box.Vectors[2][axis]);
        if (!std::isfinite(to[axis]))
        {
          const auto column =
            std::find(this->Roles.begin(), this->Roles.end(), static_cast<ColumnRole>(axis));
          fault = { RowFault::NotFinite, static_cast<int>(column - this->Roles.begin()), nullptr };
          return false;
        }
      }
      else
      {
        to[axis] = center[axis];
      }
    }
    return true;
  }

  const TableLayout& Layout;
  const Separators Between;
  const char* TextEnd;
  Real* Centers;
  Real* Radii;
  const ExtraColumns& Extras;
  std::vector<ColumnRole> Roles;
  bool IsPlain;
};
}

#endif
