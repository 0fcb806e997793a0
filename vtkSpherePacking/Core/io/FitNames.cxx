// SPDX-License-Identifier: BSD-3-Clause
#include "io/FitNames.h"

#include "io/DiameterWords.h"
#include "io/NameBrackets.h"
#include "io/NameLists.h"
#include "io/NameMeaning.h"
#include "io/PackingFileError.h"
#include "io/RemarksOnOrder.h"
#include "io/SplitNames.h"
#include "io/TableLayout.h"
#include "io/UnitsOfRemark.h"
#include "io/UsualForms.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <iterator>
#include <optional>

namespace spherepacking
{
namespace
{
using Names = std::vector<std::string_view>;

// The number at the beginning of a name, as in "2:x", "2) x" or "[2] x"; `rest` is what follows.
std::optional<std::size_t> LeadingNumber(std::string_view name, std::string_view& rest)
{
  const bool bracket = !name.empty() && (name.front() == '(' || name.front() == '[');
  std::string_view digits = name.substr(bracket ? 1 : 0);
  std::size_t number = 0;
  const auto [end, error] = std::from_chars(digits.data(), digits.data() + digits.size(), number);
  if (error != std::errc() || end == digits.data() + digits.size())
  {
    return std::nullopt;
  }
  const std::size_t length = end - digits.data();
  if (std::string_view(":.)]=-").find(*end) == std::string_view::npos)
  {
    return std::nullopt;
  }
  rest = Trim(digits.substr(length + 1));
  return number;
}

// Names and the numbers of their columns, if all names have one: "1:x 2:y" or "1: x 2: y".
struct Numbered
{
  Names Of;
  std::vector<std::size_t> Columns;
};

std::optional<Numbered> TakeNumbers(const Names& names)
{
  Numbered numbered;
  for (const std::string_view name : names)
  {
    std::string_view rest;
    if (const std::optional<std::size_t> number = LeadingNumber(name, rest))
    {
      numbered.Of.push_back(rest);
      numbered.Columns.push_back(*number);
    }
    else if (numbered.Of.empty())
    {
      return std::nullopt;
    }
    else
    {
      std::string_view& last = numbered.Of.back();
      if (!last.empty() && !IsUnit(name) && !IsNameOfTwoWords(last, name))
      {
        return std::nullopt;
      }
      const char* const begin = last.empty() ? name.data() : last.data();
      last = std::string_view(begin, name.data() + name.size() - begin);
    }
  }
  return numbered.Of.size() < 2 ? std::nullopt : std::optional(numbered);
}

// The names in the places that their numbers give them. Numbers count from 0 or from 1; which, must
// be certain. Empty if it is not.
Names InPlace(const Numbered& numbered, std::size_t count)
{
  const auto [low, high] = std::minmax_element(numbered.Columns.begin(), numbered.Columns.end());
  const bool whole = numbered.Of.size() == count && *high - *low + 1 == count && *low <= 1;
  const bool fromZero = *low == 0 && *high < count;
  const bool fromOne = *low > 0 && *high == count;
  if (!whole && !fromZero && !fromOne)
  {
    return {};
  }
  Names names(count);
  std::vector<bool> taken(count);
  for (std::size_t i = 0; i < numbered.Of.size(); ++i)
  {
    const std::size_t column = numbered.Columns[i] - (fromOne ? 1 : 0);
    if (taken[column])
    {
      return {};
    }
    taken[column] = true;
    names[column] = numbered.Of[i];
  }
  return names;
}

Names WithoutColons(Names names)
{
  for (std::string_view& name : names)
  {
    name.remove_suffix(!name.empty() && name.back() == ':');
  }
  return names;
}

// Where the unit of the name at `i` ends: after "mm" or "in mm" behind it, or else after the name.
std::size_t UnitEnd(const Names& names, std::size_t i)
{
  const std::size_t unit = i + (i + 1 < names.size() && names[i + 1] == "in" ? 2 : 1);
  return unit < names.size() && IsUnit(names[unit]) ? unit + 1 : i + 1;
}

// The unit of length that stands behind each name of the sphere, or nothing. Red has none.
std::string UnitOfSphere(const Names& names)
{
  if (names.size() > MostNames)
  {
    return {};
  }
  std::vector<NameMeaning> meanings;
  std::transform(names.begin(), names.end(), std::back_inserter(meanings), MeaningOfName);
  const auto has = [&](NameMeaning::Kind kind)
  {
    return std::any_of(meanings.begin(), meanings.end(),
      [kind](const NameMeaning& meaning) { return meaning.What == kind; });
  };
  const bool colors = has(NameMeaning::Green) && has(NameMeaning::Blue);
  std::string length;
  for (std::size_t i = 0; i < names.size(); ++i)
  {
    const std::size_t end = UnitEnd(names, i);
    const std::string unit = end > i + 1 ? LengthUnit(names[end - 1]) : std::string();
    const bool red = colors && meanings[i].IsLetter && unit.empty();
    if (!IsOfSphere(meanings[i]) || red)
    {
      continue;
    }
    if (unit.empty() || (!length.empty() && unit != length))
    {
      return {};
    }
    length = unit;
  }
  return length;
}

// Without units, if all of the sphere have one of the same length, or if one ends the line for all.
// Another length among them is a name, as is m at the end: that may be a mass.
Names WithoutUnits(const Names& names)
{
  const std::string length = UnitOfSphere(names);
  const auto lengths =
    std::count_if(names.begin(), names.end(), [](auto name) { return !LengthUnit(name).empty(); });
  Names rest;
  for (std::size_t i = 0; i < names.size();)
  {
    rest.push_back(names[i]);
    const std::size_t end = UnitEnd(names, i);
    const std::string unit = LengthUnit(names[end - 1]);
    const bool ofEach = !length.empty() && (unit == length || unit.empty());
    const bool ofAll =
      end == names.size() && lengths <= 1 && (end == i + 3 || names[end - 1] != "m");
    i = end > i + 1 && (ofEach || ofAll) ? end : i + 1;
  }
  return rest;
}

Names JoinTwoWords(const Names& names)
{
  Names joined;
  for (std::size_t i = 0; i < names.size(); ++i)
  {
    std::string_view name = names[i];
    if (i + 1 < names.size() && IsNameOfTwoWords(name, names[i + 1]))
    {
      ++i;
      const char* const end = names[i].data() + names[i].size();
      name = std::string_view(name.data(), end - name.data());
    }
    joined.push_back(name);
  }
  return joined;
}

// Without the rules of tables and slashes that stand between names.
Names WithoutRules(Names words)
{
  const auto isRule = [](std::string_view word)
  { return word.find_first_not_of("|/:") == std::string_view::npos; };
  words.erase(std::remove_if(words.begin(), words.end(), isRule), words.end());
  return words;
}

Names SplitWords(std::string_view line)
{
  return WithoutRules(
    SplitNames(WithoutLabelWord(WithoutLabel(WithoutSigns(line))), Between::Anything));
}

/// Collects the readings of one line.
class Readings
{
public:
  Readings(std::size_t count, Radii radii)
    : Count(count)
    , RadiiAre(radii)
  {
  }

  void Try(const Names& names)
  {
    this->Add(WithoutColons(names));
    if (const auto numbered = TakeNumbers(names))
    {
      if (const Names placed = InPlace(*numbered, this->Count); !placed.empty())
      {
        this->Add(placed);
      }
    }
  }

  // Between blanks, words may belong together. What may be one name of two words is not read as two
  // names, too.
  void TryWords(const Names& words)
  {
    const Names joined = JoinTwoWords(WithoutRules(words));
    this->Try(joined);
    if (const Names names = WithoutUnits(joined); names.size() != joined.size())
    {
      this->Add(WithoutColons(names));
    }
  }

  bool Fit() const { return this->Found.What == NamesFit::Fits; }

  NamesFit Result() const
  {
    NamesFit fit = this->Found;
    if (this->Differ)
    {
      return { NamesFit::Unclear, {}, {} };
    }
    if (fit.What != NamesFit::Fits && !this->Complaint.empty())
    {
      return { NamesFit::Unclear, {}, this->Complaint };
    }
    return fit;
  }

private:
  void Add(const Names& names)
  {
    if (names.size() != this->Count)
    {
      return;
    }
    std::string complaint;
    auto columns = ColumnsFromNames(names, complaint, this->RadiiAre);
    if (columns && complaint.empty())
    {
      const auto sameRole = [](const Column& a, const Column& b) { return a.Role == b.Role; };
      this->Differ |= this->Found.What == NamesFit::Fits &&
        !std::equal(columns->begin(), columns->end(), this->Found.Columns.begin(), sameRole);
      if (this->Found.What != NamesFit::Fits)
      {
        this->Found = { NamesFit::Fits, std::move(*columns), {} };
      }
      return;
    }
    std::string unused;
    if (columns || ColumnsFromNames(names, unused, Radii::Optional))
    {
      this->Complaint = !complaint.empty() ? complaint
                                           : "found names for all columns and none of a radius, "
                                             "expected one of r, radius, d, diameter";
    }
  }

  std::size_t Count;
  Radii RadiiAre;
  NamesFit Found;
  bool Differ = false;
  std::string Complaint;
};

NamesFit TwoUnits(std::string_view line)
{
  return { NamesFit::Unclear, {},
    "found several units of length in " + Quote(line.data(), line.data() + line.size()) +
      ", expected one for coordinates and radii" };
}

// Names among which one stands for all coordinates.
NamesFit FitPosition(std::string_view line, std::size_t count, Radii radii)
{
  const SpelledNames spelled = SpellPosition(line);
  if (spelled.Names.empty())
  {
    return {};
  }
  std::string names; // in one text, in which words can be joined
  for (const std::string& name : spelled.Names)
  {
    names += name + ' ';
  }
  Readings readings(count, radii);
  readings.TryWords(SplitNames(names, Between::Anything));
  if (spelled.IsClear && readings.Fit() && !SpeaksOfOtherOrder(line)) // "position (zyx)"
  {
    return UnitsOfRemark(line).size() > 1 ? TwoUnits(line) : readings.Result();
  }
  NamesFit fit;
  fit.What =
    spelled.RadiusFollows && !SpeaksOfOtherOrder(line) ? NamesFit::NoNames : NamesFit::Unclear;
  return fit;
}

// Whether a line speaks of diameters although one of its columns is a radius and no other is what
// it speaks of: "x y z r (diameter)".
bool CallsRadiusDiameter(std::string_view line, const std::vector<Column>& columns)
{
  const auto isRadius = [](const Column& column) { return column.Role == ColumnRole::Radius; };
  return std::any_of(columns.begin(), columns.end(), isRadius) && SpeaksOfDiameter(line) &&
    std::none_of(columns.begin(), columns.end(),
      [&](const Column& column) { return !isRadius(column) && SpeaksOfDiameter(column.Name); });
}

// Names in the usual forms of lists.
NamesFit FitUsual(std::string_view line, std::size_t count, Radii radii)
{
  line = WithoutLabel(WithoutSigns(line));
  std::vector<std::string_view> lines{ line };
  if (const std::string_view rest = WithoutLabelWord(line); rest != line)
  {
    lines.push_back(rest);
  }
  // Commas, tabs and wide gaps say more than single blanks, which may be within names.
  Readings readings(count, radii);
  for (const std::string_view names : lines)
  {
    for (const Between between : { Between::Commas, Between::Tabs, Between::WideGaps })
    {
      readings.Try(SplitNames(names, between));
    }
  }
  if (!readings.Fit())
  {
    for (const std::string_view names : lines)
    {
      readings.TryWords(SplitNames(names, Between::Anything));
    }
  }
  NamesFit fit = readings.Result();
  if (fit.What == NamesFit::NoNames)
  {
    fit = FitPosition(line, count, radii);
  }
  std::string complaint;
  if (fit.What == NamesFit::NoNames &&
    (ColumnsFromNames(NameWords(line), complaint) ||
      NamesSomeOfSphere(WithoutUnits(SplitWords(line)), count)))
  {
    fit.What = NamesFit::Unclear;
    fit.Complaint = complaint;
  }
  return fit;
}
}

//------------------------------------------------------------------------------
std::vector<std::string_view> NameWords(std::string_view line)
{
  Names words = SplitWords(line);
  if (const auto numbered = TakeNumbers(words))
  {
    words = numbered->Of;
  }
  return WithoutColons(WithoutUnits(words));
}

//------------------------------------------------------------------------------
bool NamesSomeOfSphere(const std::vector<std::string_view>& words, std::size_t count)
{
  std::array<bool, 4> named{};
  bool others = false;
  bool numbered = false;
  for (std::string_view word : words)
  {
    if (word == "2-d" || word == "3-d" || word == "2-D" || word == "3-D")
    {
      others = true;
      continue;
    }
    const bool hasNumber = !IsNumber(word) && LeadingNumber(word, word).has_value();
    const NameMeaning meaning = MeaningOfName(word);
    const bool axis = meaning.What == NameMeaning::Coordinate;
    const bool size = meaning.What == NameMeaning::Radius || meaning.What == NameMeaning::Diameter;
    // What gives values, such as "box x 10 y 10", names no columns.
    if (word == "=" || (!hasNumber && !word.empty() && word[0] >= '0' && word[0] <= '9'))
    {
      return false;
    }
    named[axis ? meaning.Axis : 3] |= axis || size;
    others |= !axis && !size;
    numbered |= hasNumber;
  }
  const auto names = std::count(named.begin(), named.end(), true);
  return names >= (count > 4 || !others ? 2 : 3) || (numbered && names > 0);
}

//------------------------------------------------------------------------------
bool NamesOtherColumns(std::string_view line, std::size_t count)
{
  const auto lists = [count](std::string_view text)
  { return ListOtherColumns(NameWords(text), count) || ListOtherColumns(SplitWords(text), count); };
  const std::vector<std::string> forms = UsualForms(line, count);
  return lists(line) || std::any_of(forms.begin(), forms.end(), lists);
}

//------------------------------------------------------------------------------
bool AreNumbered(std::string_view line)
{
  return TakeNumbers(SplitWords(line)).has_value();
}

//------------------------------------------------------------------------------
std::vector<std::string_view> WithoutNumbers(const std::vector<std::string_view>& names)
{
  const auto numbered = TakeNumbers(names);
  const Names placed = numbered ? InPlace(*numbered, names.size()) : Names();
  return placed.empty() ? names : placed;
}

//------------------------------------------------------------------------------
NamesFit FitNames(std::string_view line, std::size_t count, Radii radii)
{
  NamesFit fit = FitUsual(line, count, radii);
  if (fit.What != NamesFit::Fits)
  {
    for (const std::string& form : UsualForms(line, count))
    {
      NamesFit other = FitUsual(form, count, radii);
      if (other.What == NamesFit::Fits ||
        (other.What == NamesFit::Unclear && fit.Complaint.empty()))
      {
        fit = std::move(other);
      }
      if (fit.What == NamesFit::Fits)
      {
        break;
      }
    }
  }
  if (fit.What == NamesFit::Fits && CallsRadiusDiameter(line, fit.Columns))
  {
    return { NamesFit::Unclear, {},
      "found a radius and a diameter in " + Quote(line.data(), line.data() + line.size()) +
        ", expected one name for each column" };
  }
  if (fit.What != NamesFit::NoNames && fit.Complaint.empty() && HasTwoUnits(line))
  {
    return TwoUnits(line);
  }
  if (const auto bracket = FindUnclearBracket(line); fit.What == NamesFit::Fits && !bracket.empty())
  {
    return { NamesFit::Unclear, {},
      "found " + Quote(bracket.data(), bracket.data() + bracket.size()) +
        " in a bracket behind a name, expected a unit of length, one for coordinates and radii" };
  }
  return fit;
}
}
