// SPDX-License-Identifier: BSD-3-Clause
#include "io/DiameterWords.h"

#include "io/NameMeaning.h"
#include "io/RemarkWords.h"
#include "io/TableRows.h"

#include <algorithm>
#include <cstddef>
#include <set>
#include <string>
#include <vector>

namespace spherepacking
{
namespace
{
using Words = std::set<std::string_view>;

bool IsUpper(char c)
{
  return c >= 'A' && c <= 'Z';
}

bool IsDigit(char c)
{
  return c >= '0' && c <= '9';
}

// Whether "diam" stands in a word that is not one of diamonds and the like.
bool HasDiam(std::string_view word)
{
  for (std::size_t at = word.find("diam"); at != word.npos; at = word.find("diam", at + 1))
  {
    const std::string_view rest = word.substr(at + 4);
    const auto begins = [&](std::string_view other)
    { return rest.substr(0, other.size()) == other; };
    if (!begins("ond") && !begins("ant") && !begins("agn") && !begins("in"))
    {
      return true;
    }
  }
  return false;
}

// Whether a word has "di", an a with an accent in some encoding, and "metr".
bool HasAccentedDiametr(std::string_view word)
{
  for (std::size_t at = word.find("di"); at != word.npos; at = word.find("di", at + 1))
  {
    std::size_t end = at + 2;
    while (end < word.size() && word[end] < 0)
    {
      ++end;
    }
    if (end > at + 2 && word.substr(end, 4) == "metr")
    {
      return true;
    }
  }
  return false;
}

bool IsForDiameters(std::string_view word)
{
  static const std::vector<std::string_view> parts{ "durchm", "doorsned", "middellijn",
    "\xD0\xB8\xD0\xB0\xD0\xBC\xD0\xB5\xD1\x82\xD1\x80", // Russian
    "\xD0\x98\xD0\x90\xD0\x9C\xD0\x95\xD0\xA2\xD0\xA0", "\xE7\x9B\xB4\xE5\xBE\x84",
    "\xE7\x9B\xB4\xE5\xBE\x91",                             // Chinese
    "\xEC\xA7\x81\xEA\xB2\xBD", "\xEC\xA7\x80\xEB\xA6\x84", // Korean
    "rednic", "r\xC5\xAFm\xC4\x9Br", "\xE2\x8C\x80" };      // Polish, Czech, the sign
  static const Words whole{ "dia", "dias", "2r", "xyzd", "dxyz", "\xC3\x98", "\xC3\xB8",
    "\xC3\xA7"
    "ap",
    "\xC3\x87"
    "ap" };
  return HasDiam(word) || HasAccentedDiametr(word) || whole.count(word) > 0 ||
    std::any_of(parts.begin(), parts.end(),
      [word](std::string_view part) { return word.find(part) != word.npos; });
}

bool IsForRadii(std::string_view word)
{
  return MeaningOfName(word).What == NameMeaning::Radius;
}

// Whether a word says that names of columns may stand around it.
bool IsOfColumns(std::string_view word)
{
  static const Words columns{ "column", "columns", "col", "cols", "field", "fields", "spalte" };
  return columns.count(word) > 0 || IsPosition(word) || IsOfSphere(MeaningOfName(word));
}

// 2*r, "x y z 2 r" or "twice the radius"
bool IsTwiceRadius(std::string_view text, const std::vector<RemarkWord>& words)
{
  bool twice = false;
  bool radii = false;
  for (std::size_t i = 0; i < words.size(); ++i)
  {
    twice |= words[i].Lower == "twice";
    radii |= IsForRadii(words[i].Lower);
    if (words[i].Lower == "2" && i + 1 < words.size() && IsForRadii(words[i + 1].Lower))
    {
      const std::string_view gap = text.substr(words[i].End, words[i + 1].Begin - words[i].End);
      const bool times = gap.find_first_not_of(" *\xC2\xB7\xC3\x97") == gap.npos;
      if (times &&
        (gap.find_first_not_of(' ') != gap.npos || (i > 0 && IsOfColumns(words[i - 1].Lower))))
      {
        return true;
      }
    }
  }
  return twice && radii;
}

/// Looks at words that are a single d.
class Letters
{
public:
  Letters(std::string_view text, const std::vector<RemarkWord>& words)
    : Text(text)
    , All(words)
  {
    for (const RemarkWord& word : words)
    {
      const bool d = word.Lower == "d";
      this->Axes |= MeaningOfName(word.Lower).What == NameMeaning::Coordinate;
      this->Columns |= !d && IsOfColumns(word.Lower);
    }
  }

  bool MayBeDiameter(std::size_t i) const
  {
    const RemarkWord& word = this->All[i];
    const char before = word.Begin > 0 ? this->Text[word.Begin - 1] : ' ';
    const std::string_view behind = this->Text.substr(word.End);
    const bool path = behind.substr(0, 2) == ":\\" || behind.substr(0, 2) == ":/" ||
      (!this->Columns && before == '/' && behind.substr(0, 1) == "/");
    return !path && before != '%' && !this->IsDimension(i) && !this->HasValue(i) &&
      !this->IsOfPerson(i) && !this->IsOfThing(i);
  }

private:
  std::string_view Gap(std::size_t i) const // behind word i
  {
    const std::size_t end = this->All[i].End;
    return this->Text.substr(end, this->All[i + 1].Begin - end);
  }

  // 3-d or 2 D
  bool IsDimension(std::size_t i) const
  {
    static const Words dimensions{ "1", "2", "3" };
    return i > 0 && !this->Axes && dimensions.count(this->All[i - 1].Lower) > 0 &&
      this->Gap(i - 1).find_first_not_of(" -") == std::string_view::npos;
  }

  // d = 0.5; 3 and 4, and among names of columns any whole number, may be that of a column.
  bool HasValue(std::size_t i) const
  {
    if (i + 1 == this->All.size() || !IsDigit(this->All[i + 1].Lower[0]) ||
      this->Gap(i).find_first_not_of(" =:~<>+-.") != std::string_view::npos)
    {
      return false;
    }
    const bool whole = IsWhole(this->All[i + 1].Lower) &&
      this->Text.substr(this->All[i + 1].End, 1) != "." &&
      this->Gap(i).find('.') == this->Text.npos;
    const std::string& value = this->All[i + 1].Lower;
    return !whole || (!this->Columns && value != "3" && value != "4");
  }

  // J. D. Smith, Ph.D.
  bool IsOfPerson(std::size_t i) const
  {
    const RemarkWord& word = this->All[i];
    if (!IsUpper(this->Text[word.Begin]) || this->Text.substr(word.End, 1) != ".")
    {
      return false;
    }
    const bool initial = i + 1 < this->All.size() && this->All[i + 1].Lower.size() > 1 &&
      IsUpper(this->Text[this->All[i + 1].Begin]) &&
      this->Gap(i).find_first_not_of(" ", 1) == std::string_view::npos;
    const bool glued = !this->Columns && word.Begin > 0 && this->Text[word.Begin - 1] == '.';
    return initial || glued;
  }

  // Appendix D
  bool IsOfThing(std::size_t i) const
  {
    return i > 0 && !this->Columns && IsUpper(this->Text[this->All[i].Begin]) &&
      this->All[i - 1].Lower.size() > 3 && this->Gap(i - 1) == " ";
  }

  std::string_view Text;
  const std::vector<RemarkWord>& All;
  bool Axes = false;
  bool Columns = false;
};
}

//------------------------------------------------------------------------------
bool SpeaksOfDiameter(std::string_view remark)
{
  const std::vector<RemarkWord> words = SplitRemark(remark);
  const auto has = [&](std::string_view word)
  {
    return std::any_of(
      words.begin(), words.end(), [word](const RemarkWord& other) { return other.Lower == word; });
  };
  if (std::any_of(words.begin(), words.end(),
        [](const RemarkWord& word) { return IsForDiameters(word.Lower); }) ||
    IsTwiceRadius(remark, words))
  {
    return true;
  }
  if (!has("d"))
  {
    return false;
  }
  const Letters letters(remark, words);
  for (std::size_t i = 0; i < words.size(); ++i)
  {
    if (words[i].Lower == "d" && letters.MayBeDiameter(i))
    {
      return true;
    }
  }
  return false;
}
}
