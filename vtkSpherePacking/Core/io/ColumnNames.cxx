// SPDX-License-Identifier: BSD-3-Clause
#include "io/ColumnNames.h"

#include "io/DiameterWords.h"
#include "io/NameBrackets.h"
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
  RoleFinder(const std::vector<std::string_view>& names, NamesBy by)
    : Names(names)
    , By(by)
  {
    this->Meanings.reserve(names.size());
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
    bool sized = false;
    for (const Clarity least : { Clarity::Short, Clarity::Other })
    {
      sized = sized || this->FindSize(NameMeaning::Radius, ColumnRole::Radius, least) ||
        this->FindSize(NameMeaning::Diameter, ColumnRole::Diameter, least);
    }
    if (!sized && this->Rejected.empty() && radii == Radii::Required)
    {
      return std::nullopt;
    }
    if (!sized && radii == Radii::Required)
    {
      this->Complain(this->Rejected);
    }
    this->CheckBrackets();
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
    const bool color =
      has[NameMeaning::Green] && has[NameMeaning::Blue] && !this->HasColorsInWords();
    const std::string caseOfColors = this->CaseOfColors();
    const bool distance =
      this->By == NamesBy::File && (has[NameMeaning::PolarAngle] || has[NameMeaning::Azimuth]);
    if (!color && !distance)
    {
      return;
    }
    for (std::size_t i = 0; i < this->Meanings.size(); ++i)
    {
      NameMeaning& meaning = this->Meanings[i];
      const bool red = color && meaning.Unit.empty() && // no color has a unit
        (caseOfColors.empty() || this->Names[i] == caseOfColors);
      const bool again = red && !this->Rejected.empty();
      if (meaning.What == NameMeaning::Radius && meaning.IsLetter && (red || distance))
      {
        this->Rejected = "found " + QuoteName(this->Names[i]) +
          (red ? ", which is red beside green and blue, a color"
               : ", which is a distance from the origin or an axis beside an angle such as theta "
                 "or phi") +
          ", expected a column radius or diameter, or radius=\"" + std::string(this->Names[i]) +
          "\" (--radius) if it is one";
        this->Rejected = !again ? this->Rejected
                                : "found the column " + QuoteName(this->Names[i]) +
            " twice beside green and blue, expected a column radius or diameter beside red";
        meaning.What = NameMeaning::Other;
      }
    }
  }

  bool HasName(std::string_view name) const
  {
    return std::any_of(this->Names.begin(), this->Names.end(),
      [name](std::string_view other)
      {
        return std::equal(other.begin(), other.end(), name.begin(), name.end(),
          [](char a, char b) { return a == b || (a >= 'A' && a <= 'Z' && a - 'A' + 'a' == b); });
      });
  }

  // Whether red is called so, beside green and blue, so that r is not red.
  bool HasColorsInWords() const
  {
    return this->HasName("red") && this->HasName("green") && this->HasName("blue") &&
      !(this->HasName("g") && this->HasName("b"));
  }

  // What red must be called where both r and R are there, of which g and b, or G and B, tell one.
  std::string CaseOfColors() const
  {
    const auto has = [&](const char* name)
    { return std::find(this->Names.begin(), this->Names.end(), name) != this->Names.end(); };
    const bool small = has("r") && has("g") && has("b");
    const bool large = has("R") && has("G") && has("B");
    return !has("r") || !has("R") || small == large ? "" : small ? "r" : "R";
  }

  // The coordinates are those of the only family of names that has all three; x, y, z before
  // others.
  bool FindCoordinates()
  {
    std::map<std::string, int> axes = this->AxesOfFamilies();
    const auto isComplete = [](const auto& family) { return family.second == 7; };
    const auto noneComplete = [&] { return std::none_of(axes.begin(), axes.end(), isComplete); };
    for (const auto take :
      { &RoleFinder::JoinFamiliesOfUnits, &RoleFinder::TakeCoordinatesOfParticles })
    {
      if (noneComplete())
      {
        (this->*take)();
        axes = this->AxesOfFamilies();
      }
    }
    if (noneComplete())
    {
      return false;
    }
    const auto plain = axes.find(PlainFamily);
    const bool isPlain = plain != axes.end() && isComplete(*plain);
    std::array<std::vector<std::size_t>, 3> columns;
    for (std::size_t i = 0; i < this->Meanings.size(); ++i)
    {
      const NameMeaning& meaning = this->Meanings[i];
      if (meaning.What == NameMeaning::Coordinate &&
        (isPlain ? meaning.Family == PlainFamily : axes[meaning.Family] == 7))
      {
        columns[meaning.Axis].push_back(i);
      }
    }
    for (int axis = 0; axis < 3; ++axis)
    {
      this->SetRole(columns[axis], static_cast<ColumnRole>(axis));
      this->CheckUnit(columns[axis][0]);
    }
    return true;
  }

  // Which axes there are of each family of names, as bits.
  std::map<std::string, int> AxesOfFamilies() const
  {
    std::map<std::string, int> axes;
    for (const NameMeaning& meaning : this->Meanings)
    {
      if (meaning.What == NameMeaning::Coordinate)
      {
        axes[meaning.Family] |= 1 << meaning.Axis;
      }
    }
    return axes;
  }

  // px, py, pz where no other names are those of coordinates.
  void TakeCoordinatesOfParticles()
  {
    for (std::size_t i = 0; i < this->Meanings.size(); ++i)
    {
      if (auto meaning = CoordinateOfParticle(this->Names[i]))
      {
        this->Meanings[i] = std::move(*meaning);
      }
    }
  }

  // x_m, y_mm, z_m, which CheckUnit then finds.
  void JoinFamiliesOfUnits()
  {
    for (NameMeaning& meaning : this->Meanings)
    {
      if (meaning.What == NameMeaning::Coordinate && meaning.IsUnitGlued)
      {
        meaning.Family.erase(meaning.Family.rfind('_'));
      }
    }
  }

  /// How sure a name is that of a size.
  enum class Clarity
  {
    None,
    Other, ///< with a unit glued that coordinates do not have, or with what it is of
    Short,
    Full
  };

  // A unit that is part of a short name, as in r_m, is one only if the coordinates have units, too.
  Clarity ClarityOf(const NameMeaning& meaning) const
  {
    const bool otherUnit = meaning.IsUnitGlued && meaning.Unit != this->Unit;
    const bool isUnit = !otherUnit || meaning.IsFullWord || !this->Unit.empty();
    return !isUnit                     ? Clarity::None
      : otherUnit || meaning.IsOfParts ? Clarity::Other
      : meaning.IsFullWord             ? Clarity::Full
                                       : Clarity::Short;
  }

  // The radius, or the diameter, by the word that is the clearest of those there.
  bool FindSize(NameMeaning::Kind kind, ColumnRole role, Clarity least)
  {
    Clarity clearest = least;
    std::vector<std::size_t> found;
    for (std::size_t i = 0; i < this->Meanings.size(); ++i)
    {
      const NameMeaning& meaning = this->Meanings[i];
      const Clarity clear = meaning.What == kind ? this->ClarityOf(meaning) : Clarity::None;
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
    if (role == ColumnRole::Radius && SpeaksOfDiameter(this->Meanings[found[0]].Unknown))
    {
      this->Complain("found a radius and a diameter in " + QuoteName(this->Names[found[0]]) +
        ", expected one name for each column");
    }
    return true;
  }

  // What is in brackets may say that a number is no length, or one in another unit: "r (log10)".
  void CheckBrackets()
  {
    const auto unknownOf = [&](std::size_t i) -> const std::string&
    { return this->Meanings[i].Unknown; };
    std::vector<std::size_t> sphere;
    for (std::size_t i = 0; i < this->Columns.size(); ++i)
    {
      if (this->Columns[i].Role <= ColumnRole::Diameter)
      {
        sphere.push_back(i);
      }
    }
    const bool shared = sphere.size() > 3 &&
      std::all_of(sphere.begin(), sphere.end(),
        [&](std::size_t i) { return unknownOf(i) == unknownOf(sphere[0]); });
    for (const std::size_t i : sphere)
    {
      const std::string& unknown = unknownOf(i);
      const bool isSize = this->Columns[i].Role > ColumnRole::Z;
      const bool plain = IsPlainBracket(unknown) ||
        MeaningOfName(unknown).What == this->Meanings[i].What; // radius (r)
      if (!unknown.empty() &&
        (IsNoLength(unknown) || (!shared && (IsScaled(unknown) || (isSize && !plain)))))
      {
        this->Complain("found " + QuoteName(this->Names[i]) +
          ", whose bracket holds no unit of length that is known, expected one unit for "
          "coordinates and radii");
      }
    }
  }

  void SetRole(const std::vector<std::size_t>& columns, ColumnRole role)
  {
    this->Columns[columns[0]].Role = role;
    if (columns.size() > 1)
    {
      this->Complain(Twice(this->Names[columns[0]], this->Names[columns[1]]));
    }
  }

  // Lengths in two units would be spheres of a wrong size. What is in brackets may be a unit that
  // is not known.
  void CheckUnit(std::size_t column)
  {
    const NameMeaning& meaning = this->Meanings[column];
    if (meaning.Unit.empty() && meaning.Unknown.empty())
    {
      return;
    }
    if (!this->HasUnit)
    {
      this->Unit = meaning.Unit;
      this->Unknown = meaning.Unknown;
      this->UnitOf = column;
      this->HasUnit = true;
    }
    const bool known = !meaning.Unit.empty() || !this->Unit.empty();
    if (known && (meaning.Unit != this->Unit || meaning.Unknown != this->Unknown))
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
  NamesBy By;
  std::vector<NameMeaning> Meanings;
  std::vector<Column> Columns;
  bool HasUnit = false; // whether some coordinate has
  std::string Unit;     // the first of them, or what may be one
  std::string Unknown;
  std::size_t UnitOf = 0;
  std::string Rejected; // why r is no radius, if so
  std::string Complaint;
};
}

//------------------------------------------------------------------------------
std::optional<std::vector<Column>> ColumnsFromNames(
  const std::vector<std::string_view>& names, std::string& complaint, Radii radii, NamesBy by)
{
  if (names.size() > MostNames)
  {
    return std::nullopt;
  }
  return RoleFinder(names, by).Find(complaint, radii);
}
}
