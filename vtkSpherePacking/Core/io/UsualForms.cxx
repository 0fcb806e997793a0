// SPDX-License-Identifier: BSD-3-Clause
#include "io/UsualForms.h"

#include "io/NameLists.h"
#include "io/NameMeaning.h"
#include "io/SplitNames.h"

#include <algorithm>
#include <set>

namespace spherepacking
{
namespace
{
using Names = std::vector<std::string_view>;

constexpr std::string_view Opening = "([{<\"'`";
constexpr std::string_view Closing = ")]}>\"'`";
constexpr std::string_view Brackets = "([{<)]}>";

// Where the bracket or quote that opens `text` closes, or npos.
std::size_t ClosingAt(std::string_view text)
{
  const std::size_t kind = text.empty() ? Opening.npos : Opening.find(text.front());
  if (kind == Opening.npos)
  {
    return text.npos;
  }
  int depth = 1;
  for (std::size_t i = 1; i < text.size(); ++i)
  {
    const bool closes = text[i] == Closing[kind];
    depth += closes ? -1 : text[i] == Opening[kind] ? 1 : 0;
    if (depth == 0)
    {
      return i;
    }
  }
  return text.npos;
}

// What is in the one bracket or pair of quotes that all names are in, with a unit behind it. False
// if they are not.
bool Unwrap(std::string_view text, std::string_view& inner, std::string& unit)
{
  const std::size_t end = ClosingAt(text);
  if (end == text.npos)
  {
    return false;
  }
  std::string_view rest = Trim(text.substr(end + 1));
  rest = rest.find_first_not_of(".;:,") == rest.npos ? std::string_view() : rest;
  const bool bracket = rest.size() > 2 && ClosingAt(rest) == rest.size() - 1;
  unit = UnitInBracket(bracket ? rest.substr(1, rest.size() - 2) : rest);
  inner = Trim(text.substr(1, end - 1));
  return rest.empty() || !unit.empty();
}

// Without "names =" before a bracket.
std::string_view WithoutAssignment(std::string_view text)
{
  const std::size_t at = text.find_first_of(Opening);
  const std::string_view before = Trim(text.substr(0, std::min(at, text.size())));
  if (at == text.npos || before.size() < 2 || before.back() != '=')
  {
    return text;
  }
  const std::string_view word = Trim(before.substr(0, before.size() - 1));
  const bool one = word.find_first_of(" \t,;=") == word.npos;
  return one && !IsOfSphere(MeaningOfName(word)) && !IsPosition(word) ? text.substr(at) : text;
}

bool IsCoordinate(std::string_view word)
{
  return MeaningOfName(word).What == NameMeaning::Coordinate;
}

// "(x y z) (d)" without its brackets. Empty if there is nothing but names of the sphere in none, or
// if a bracket explains the word before it.
std::string WithoutBrackets(std::string_view text)
{
  std::string loose;
  bool found = false;
  for (std::size_t p = 0; p < text.size(); ++p)
  {
    const std::size_t kind = Brackets.substr(0, 4).find(text[p]);
    const std::size_t closing = kind == text.npos ? kind : text.find_first_of(Brackets, p + 1);
    const bool closes = closing != text.npos && text[closing] == Brackets[kind + 4];
    const std::string_view within = closes ? text.substr(p + 1, closing - p - 1) : "";
    const Names words = SplitNames(within, Between::Anything);
    const bool names = !words.empty() &&
      (std::count_if(words.begin(), words.end(), IsCoordinate) == 3 ||
        std::all_of(words.begin(), words.end(),
          [](auto word) { return IsOfSphere(MeaningOfName(word)) || IsIdName(word); }));
    if (!names)
    {
      loose += text[p];
      continue;
    }
    const std::string_view before = Trim(loose);
    const std::size_t gap = before.find_last_of(" \t,;");
    const std::string_view last = before.substr(gap == before.npos ? 0 : gap + 1);
    const bool inBracket = found && !last.empty() && last.back() == ',';
    if (!last.empty() && !inBracket && !IsCoordinate(last) && !IsIdName(last))
    {
      return {};
    }
    loose += ' ' + std::string(within) + " , ";
    found = true;
    p = closing;
  }
  return found ? loose : std::string();
}

// The pieces between `delimiter`, with commas between, if there are `count` or if x, y and z are
// among them, and none is empty.
std::string WithCommas(std::string_view text, char delimiter, std::size_t count)
{
  std::string commas;
  std::size_t pieces = 0;
  std::size_t axes = 0;
  for (std::size_t begin = 0; begin <= text.size();)
  {
    const std::size_t end = std::min(text.find(delimiter, begin), text.size());
    const std::string_view piece = Trim(text.substr(begin, end - begin));
    const bool outer = begin == 0 || end == text.size();
    if (piece.empty() && !outer)
    {
      return {};
    }
    if (!piece.empty())
    {
      commas += (pieces++ > 0 ? ", " : "") + std::string(piece);
      const std::string_view word = piece.substr(0, piece.find_first_of(" \t"));
      axes += word.size() == 1 && IsCoordinate(word) ? 1 : 0;
    }
    begin = end + 1;
  }
  return pieces == count || axes == 3 ? commas : std::string();
}

// "xyzd" as "x y z d", if it comes first or behind ids. "xyzr" says no more than places do, unless
// there are names for all columns.
std::string WithLetters(std::string_view text, std::size_t count)
{
  static const std::set<std::string> glued{ "xyzr", "xyzd", "rxyz", "dxyz" };
  std::string letters;
  bool found = false;
  const Names words = SplitNames(text, Between::Anything);
  for (const std::string_view word : words)
  {
    std::string lower(word);
    std::transform(lower.begin(), lower.end(), lower.begin(),
      [](char c) { return c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c; });
    const bool here = !found && glued.count(lower) > 0;
    const bool byPlace = here && lower == "xyzr" && words.size() + 3 != count;
    if (byPlace || (!here && !found && !IsIdName(word)))
    {
      return {};
    }
    found |= here;
    letters += here ? std::string{ lower[0], ' ', lower[1], ' ', lower[2], ' ', lower[3] }
                    : std::string(word);
    letters += ' ';
  }
  return found ? letters : std::string();
}
}

//------------------------------------------------------------------------------
std::vector<std::string> UsualForms(std::string_view line, std::size_t count)
{
  if (line.find(NoBreakSpace) != line.npos)
  {
    const std::string plain = WithPlainBlanks(line);
    std::vector<std::string> forms = UsualForms(plain, count);
    forms.insert(forms.begin(), plain);
    return forms;
  }
  std::string_view names = WithoutAssignment(WithoutLabelWord(WithoutLabel(WithoutSigns(line))));
  std::vector<std::string> forms;
  std::string unit;
  std::string_view inner;
  if (Unwrap(names, inner, unit))
  {
    names = inner;
    forms.push_back(std::string(names) + (unit.empty() ? "" : " in " + unit));
  }
  const auto has = [names](const char* letters)
  { return names.find_first_of(letters) != names.npos; };
  if (!has("xX") || !has("yY") || !has("zZ"))
  {
    return forms;
  }
  forms.push_back(WithoutBrackets(names));
  for (const char delimiter : std::string_view("|/:\\&"))
  {
    forms.push_back(WithCommas(names, delimiter, count));
  }
  const bool word = names.find_first_of(" \t,;") == names.npos;
  for (const char delimiter : std::string_view(word ? "-+_." : ""))
  {
    forms.push_back(WithCommas(names, delimiter, count));
  }
  forms.push_back(WithLetters(names, count));
  forms.erase(std::remove(forms.begin(), forms.end(), std::string()), forms.end());
  return forms;
}
}
