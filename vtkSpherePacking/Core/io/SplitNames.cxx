// SPDX-License-Identifier: BSD-3-Clause
#include "io/SplitNames.h"

#include "io/TableRows.h"

#include <algorithm>
#include <set>

namespace spherepacking
{
namespace
{
using Names = std::vector<std::string_view>;

bool IsGap(char c)
{
  return c == ' ' || c == '\t';
}

// The first word of a line, up to a blank.
std::string_view FirstWord(std::string_view line)
{
  return line.substr(0, std::min(line.find_first_of(" \t"), line.size()));
}
}

//------------------------------------------------------------------------------
std::string_view Trim(std::string_view text)
{
  while (!text.empty() && IsGap(text.front()))
  {
    text.remove_prefix(1);
  }
  while (!text.empty() && IsGap(text.back()))
  {
    text.remove_suffix(1);
  }
  return text;
}

//------------------------------------------------------------------------------
std::size_t BracketEnd(std::string_view line, std::size_t at)
{
  const std::size_t end = line.find(line[at] == '(' ? ')' : ']', at);
  return end == line.npos ? at : end;
}

//------------------------------------------------------------------------------
std::vector<std::string_view> SplitNames(std::string_view line, Between between)
{
  const auto separates = [&](std::size_t i)
  {
    const char c = line[i];
    const bool comma = c == ',' || c == ';';
    const bool wide = IsGap(c) &&
      (c == '\t' || (i + 1 < line.size() && IsGap(line[i + 1])) || (i > 0 && IsGap(line[i - 1])));
    return between == Between::Anything ? comma || IsGap(c)
      : between == Between::Commas      ? comma
      : between == Between::Tabs        ? c == '\t'
                                        : wide;
  };
  Names names;
  std::size_t begin = 0;
  std::size_t noBracket = 0; // up to here brackets do not close
  const auto take = [&](std::size_t end)
  {
    std::string_view name = Trim(line.substr(begin, end - begin));
    if (name.size() >= 2 && name.front() == name.back() &&
      std::string_view("\"'`$").find(name.front()) != std::string_view::npos)
    {
      name = name.substr(1, name.size() - 2);
    }
    const bool bracket = !name.empty() && (name.front() == '(' || name.front() == '[');
    const bool unit = bracket && BracketEnd(name, 0) == name.size() - 1 &&
      !IsWhole(name.substr(1, name.size() - 2));
    const bool gap = between == Between::Anything || between == Between::WideGaps;
    if (!name.empty() ? !unit || !gap : !gap)
    {
      names.push_back(name);
    }
    begin = end + 1;
  };
  for (std::size_t i = 0; i < line.size(); ++i)
  {
    if ((line[i] == '(' || line[i] == '[') && i >= noBracket)
    {
      const std::size_t end = BracketEnd(line, i);
      noBracket = end == i ? line.size() : noBracket;
      i = end;
    }
    else if (separates(i))
    {
      take(i);
    }
  }
  take(line.size());
  return names;
}

//------------------------------------------------------------------------------
std::string_view WithoutSigns(std::string_view line)
{
  line = Trim(line);
  while (!line.empty() && std::string_view("#%/!").find(line.front()) != std::string_view::npos)
  {
    line.remove_prefix(1);
  }
  return Trim(line);
}

//------------------------------------------------------------------------------
std::string_view WithoutLabel(std::string_view line)
{
  const auto isLabel = [](std::string_view word)
  { return word.size() > 1 && word.back() == ':' && (word[0] < '0' || word[0] > '9'); };
  const std::string_view word = FirstWord(line);
  const std::string_view rest = Trim(line.substr(word.size()));
  const bool label = isLabel(word) && word.size() > 2 && !isLabel(FirstWord(rest));
  return label ? rest : line;
}

//------------------------------------------------------------------------------
std::string_view WithoutLabelWord(std::string_view line)
{
  static const std::set<std::string_view> labels{ "columns", "Columns", "fields", "Fields", "names",
    "Names", "header", "variables", "VARIABLES", "C" };
  const std::string_view word = FirstWord(line);
  line = labels.count(word) > 0 ? Trim(line.substr(word.size())) : line;
  return line.substr(0, 1) == "=" ? Trim(line.substr(1)) : line;
}
}
