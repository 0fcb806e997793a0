// SPDX-License-Identifier: BSD-3-Clause
#include "io/UnitsOfRemark.h"

#include "io/NameBrackets.h"
#include "io/NameMeaning.h"
#include "io/SplitNames.h"
#include "io/TableLayout.h"

#include <algorithm>
#include <cstddef>
#include <vector>

namespace spherepacking
{
namespace
{
bool IsOfWord(char c)
{
  return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || c < 0;
}

bool IsPlaceOrSize(std::string_view word)
{
  return IsOfSphere(MeaningOfName(word)) || IsPosition(word);
}
}

//------------------------------------------------------------------------------
std::set<std::string> UnitsOfRemark(std::string_view remark)
{
  if (remark.find(NoBreakSpace) != remark.npos)
  {
    return UnitsOfRemark(WithPlainBlanks(remark));
  }
  std::set<std::string> units;
  std::string_view before;
  for (std::size_t p = 0; p < remark.size();)
  {
    std::size_t end = p;
    while (end < remark.size() && IsOfWord(remark[end]))
    {
      ++end;
    }
    if (end == p)
    {
      ++p;
      continue;
    }
    const std::string_view word = remark.substr(p, end - p);
    const std::size_t last = p == 0 ? remark.npos : remark.find_last_not_of(" \t", p - 1);
    const char sign = last == remark.npos ? ' ' : remark[last];
    const bool value = sign >= '0' && sign <= '9';
    const bool said = before == "in" || std::string_view("([{</_:").find(sign) != remark.npos;
    const bool ofOther = (sign == '/' && !IsPlaceOrSize(before)) ||
      (end < remark.size() && std::string_view("/^*0123456789").find(remark[end]) != remark.npos);
    const std::string unit = LengthUnit(word);
    if (!unit.empty() && !value && !ofOther && (said || unit != "m"))
    {
      units.insert(unit);
    }
    before = word;
    p = end;
  }
  return units;
}

//------------------------------------------------------------------------------
bool HasTwoUnits(std::string_view line)
{
  std::set<std::string> units;
  bool known = false;
  std::size_t namesEnd = line.npos; // where a bracket of names has ended, "(x, y, z) [mm]"
  for (const NameBracket& bracket : FindBrackets(line))
  {
    const std::string unit = UnitInBracket(bracket.Text);
    const std::vector<std::string_view> words = SplitNames(bracket.Text, Between::Anything);
    const bool names = std::any_of(words.begin(), words.end(),
      [](auto each) { return IsOfSphere(MeaningOfName(each)) || IsNumber(each); });
    const bool ofSphere = bracket.Before == namesEnd || IsPlaceOrSize(bracket.Name);
    namesEnd = names ? bracket.End : line.npos;
    if (ofSphere && !words.empty() && (!unit.empty() || !names))
    {
      units.insert(unit.empty() ? "?" + std::string(bracket.Text) : unit);
      known |= !unit.empty();
    }
  }
  return known && units.size() > 1;
}
}
