// SPDX-License-Identifier: BSD-3-Clause
#include "io/ColumnNames.h"

#include "io/NameMeaning.h"
#include "io/PackingFileError.h"
#include "bridge/PrintableText.h"

#include <algorithm>
#include <array>
#include <map>
#include <unordered_map>

namespace spherepacking
{
namespace
{
std::string QuoteName(std::string_view name)
{
  return Quote(name.data(), name.data() + name.size());
}

std::string Twice(std::string_view earlier, std::string_view later)
{
  return "found the columns " + QuoteName(earlier) + " and " + QuoteName(later) +
    ", which name one thing twice, expected each name once";
}

/// Gives roles to the columns of one table, of which it knows all names.
class RoleFinder
{
public:
  explicit RoleFinder(const std::vector<std::string_view>& names)
    : Names(names)
  {
    for (const std::string_view name : names)
    {
      this->Meanings.push_back(MeaningOfName(name));
    }
    this->RejectColorsAndDistances();
  }

  std::optional<std::vector<Column>> Find(std::string& complaint, Radii radii)
  {
    this->Complaint.clear();
    this->Columns.assign(this->Names.size(), Column{ ColumnRole::Extra, {} });
    if (!this->FindCoordinates())
    {
      return std::nullopt;
    }
    const bool sized = this->FindSize(NameMeaning::Radius, ColumnRole::Radius) ||
      this->FindSize(NameMeaning::Diameter, ColumnRole::Diameter);
    if (!sized && this->Rejected.empty() && radii == Radii::Required)
    {
      return std::nullopt;
    }
    if (!sized && radii == Radii::Required)
    {
      this->Complain(this->Rejected);
    }
    this->SetNames();
    complaint = this->Complaint;
    return std::move(this->Columns);
  }

private:
  void Complain(const std::string& sentence)
  {
    this->Complaint = this->Complaint.empty() ? sentence : this->Complaint;
  }

  // R beside G and B is red, r beside an angle is the distance from the origin or an axis.
  void RejectColorsAndDistances()
  {
    std::array<bool, NameMeaning::Kinds> has{};
    for (const NameMeaning& meaning : this->Meanings)
    {
      has[meaning.What] = true;
    }
    const bool color = has[NameMeaning::Green] && has[NameMeaning::Blue];
    const bool distance = has[NameMeaning::PolarAngle] || has[NameMeaning::Azimuth];
    if (!color && !distance)
    {
      return;
    }
    for (std::size_t i = 0; i < this->Meanings.size(); ++i)
    {
      NameMeaning& meaning = this->Meanings[i];
      const bool red = color && meaning.Unit.empty(); // no color has a unit
      if (meaning.What == NameMeaning::Radius && meaning.IsLetter && (red || distance))
      {
        this->Rejected = "found " + QuoteName(this->Names[i]) +
          (red ? ", which is red beside green and blue, a color"
               : ", which is a distance from the origin or an axis beside an angle such as theta "
                 "or phi") +
          ", expected a column radius or diameter";
        meaning.What = NameMeaning::Other;
      }
    }
  }

  // The coordinates are those of the only family of names that has all three; x, y, z before
  // others.
  bool FindCoordinates()
  {
    std::map<std::string, int> axes; // which of a family are there, as bits
    for (const NameMeaning& meaning : this->Meanings)
    {
      if (meaning.What == NameMeaning::Coordinate)
      {
        axes[meaning.Family] |= 1 << meaning.Axis;
      }
    }
    std::vector<std::string> complete;
    for (const auto& [family, bits] : axes)
    {
      if (bits == 7)
      {
        complete.push_back(family);
      }
    }
    if (complete.empty())
    {
      return false;
    }
    const bool plain = std::find(complete.begin(), complete.end(), PlainFamily) != complete.end();
    const std::string chosen = plain ? PlainFamily : complete.front();
    std::array<std::vector<std::size_t>, 3> columns;
    for (std::size_t i = 0; i < this->Meanings.size(); ++i)
    {
      const NameMeaning& meaning = this->Meanings[i];
      if (meaning.What == NameMeaning::Coordinate &&
        (plain ? meaning.Family == chosen : axes[meaning.Family] == 7))
      {
        columns[meaning.Axis].push_back(i);
      }
    }
    for (int axis = 0; axis < 3; ++axis)
    {
      this->SetRole(columns[axis], static_cast<ColumnRole>(axis));
    }
    this->Unit = this->Meanings[columns[0][0]].Unit;
    this->UnitOf = columns[0][0];
    this->CheckUnit(columns[1][0]);
    this->CheckUnit(columns[2][0]);
    return true;
  }

  // The radius, or the diameter, by the word that is the clearest of those there.
  bool FindSize(NameMeaning::Kind kind, ColumnRole role)
  {
    int clearest = 0;
    std::vector<std::size_t> found;
    for (std::size_t i = 0; i < this->Meanings.size(); ++i)
    {
      const NameMeaning& meaning = this->Meanings[i];
      // A unit that is part of the name, as in r_mm, is one only if the coordinates have it, too.
      if (meaning.What != kind || (meaning.IsUnitGlued && meaning.Unit != this->Unit))
      {
        continue;
      }
      const int clear = meaning.IsFullWord ? 2 : 1;
      if (clear > clearest)
      {
        found.clear();
        clearest = clear;
      }
      if (clear == clearest)
      {
        found.push_back(i);
      }
    }
    if (found.empty())
    {
      return false;
    }
    this->SetRole(found, role);
    this->CheckUnit(found[0]);
    return true;
  }

  void SetRole(const std::vector<std::size_t>& columns, ColumnRole role)
  {
    this->Columns[columns[0]].Role = role;
    if (columns.size() > 1)
    {
      this->Complain(Twice(this->Names[columns[0]], this->Names[columns[1]]));
    }
  }

  // Lengths in two units would be spheres of a wrong size.
  void CheckUnit(std::size_t column)
  {
    const std::string& unit = this->Meanings[column].Unit;
    if (!unit.empty() && !this->Unit.empty() && unit != this->Unit)
    {
      this->Complain("found the units of " + QuoteName(this->Names[this->UnitOf]) + " and " +
        QuoteName(this->Names[column]) + ", expected one unit for coordinates and radii");
    }
  }

  void SetNames()
  {
    std::unordered_map<std::string, std::size_t> seen;
    for (std::size_t i = 0; i < this->Columns.size(); ++i)
    {
      Column& column = this->Columns[i];
      column.Name = PrintableText(this->Names[i]);
      if (column.Name.empty())
      {
        column.Name = "column_" + std::to_string(i + 1);
      }
      if (column.Role == ColumnRole::Extra && !seen.emplace(column.Name, i).second)
      {
        this->Complain(Twice(column.Name, column.Name));
      }
    }
  }

  const std::vector<std::string_view>& Names;
  std::vector<NameMeaning> Meanings;
  std::vector<Column> Columns;
  std::string Unit; // of x
  std::size_t UnitOf = 0;
  std::string Rejected; // why r is no radius, if so
  std::string Complaint;
};
}

//------------------------------------------------------------------------------
std::optional<std::vector<Column>> ColumnsFromNames(
  const std::vector<std::string_view>& names, std::string& complaint, Radii radii)
{
  return RoleFinder(names).Find(complaint, radii);
}
}
