// SPDX-License-Identifier: BSD-3-Clause
#include "io/XyzComment.h"

#include "io/Number.h"
#include "io/PackingFileError.h"
#include "io/Separators.h"

#include <algorithm>
#include <cmath>

namespace spherepacking
{
namespace
{
using Fields = std::vector<std::string_view>;

std::string LowerCase(std::string_view text)
{
  std::string lower(text);
  // Not std::tolower, which depends on the locale.
  std::transform(lower.begin(), lower.end(), lower.begin(),
    [](char c) { return c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c; });
  return lower;
}

bool IsBlankChar(char c)
{
  return c == ' ' || c == '\t';
}

// Takes the value off the front of `rest`: quoted, in braces or brackets, or up to a blank.
std::string TakeValue(std::string_view& rest)
{
  std::string value;
  const char open = rest.empty() ? 0 : rest.front();
  const char close = open == '"' || open == '\'' ? open : open == '{' ? '}' : 0;
  std::size_t at = close ? 1 : 0;
  int depth = 0;
  for (; at < rest.size(); ++at)
  {
    const char c = rest[at];
    if (close ? c == close : IsBlankChar(c) && depth == 0)
    {
      break;
    }
    depth += !close && c == '[';
    depth -= !close && c == ']';
    if (c == '\\' && close && at + 1 < rest.size())
    {
      ++at;
    }
    value += rest[at];
  }
  rest.remove_prefix(std::min(at + (close ? 1 : 0), rest.size()));
  return value;
}

// The fields of a list, separated by blanks or commas, in brackets or not.
Fields ListItems(std::string& list)
{
  for (char& c : list)
  {
    c = c == ',' || c == '[' || c == ']' ? ' ' : c;
  }
  list += '\n';
  return Separators::Blanks().Split(list.data());
}

std::optional<double> NumberOf(std::string_view field)
{
  const std::string text(field);
  double value;
  const char* const end = text.data() + text.size();
  const bool good = ParseNumber(text.data(), end, value) == end && std::isfinite(value);
  return good ? std::optional<double>(value) : std::nullopt;
}
}

//------------------------------------------------------------------------------
std::optional<vtkIdType> XyzCount(std::string_view line)
{
  while (!line.empty() && IsBlankChar(line.back()))
  {
    line.remove_suffix(1);
  }
  line.remove_prefix(std::min(line.find_first_not_of(" \t"), line.size()));
  const std::optional<double> count = NumberOf(line);
  return count && IsCount(*count) ? std::optional<vtkIdType>(static_cast<vtkIdType>(*count))
                                  : std::nullopt;
}

//------------------------------------------------------------------------------
XyzComment::XyzComment(std::string_view line)
{
  const auto skipBlanks = [](std::string_view& text)
  { text.remove_prefix(std::min(text.find_first_not_of(" \t"), text.size())); };
  for (skipBlanks(line); !line.empty(); skipBlanks(line))
  {
    std::string_view rest = line;
    const std::size_t keyEnd = std::min(rest.find_first_of(" \t="), rest.size());
    const std::string key = LowerCase(rest.substr(0, keyEnd));
    rest.remove_prefix(keyEnd);
    line = rest;
    skipBlanks(rest);
    if (!rest.empty() && rest.front() == '=')
    {
      rest.remove_prefix(1);
      skipBlanks(rest);
      this->Entries.push_back({ key, TakeValue(rest) });
      line = rest;
    }
  }
}

//------------------------------------------------------------------------------
std::optional<std::string> XyzComment::Find(std::string_view key) const
{
  const auto found = std::find_if(this->Entries.begin(), this->Entries.end(),
    [key](const Entry& entry) { return entry.Key == key; });
  return found == this->Entries.end() ? std::nullopt : std::optional<std::string>(found->Value);
}

//------------------------------------------------------------------------------
std::array<std::optional<double>, 3> XyzComment::Times() const
{
  const auto number = [this](std::string_view key)
  {
    const auto value = this->Find(key);
    return value ? NumberOf(*value) : std::nullopt;
  };
  return { number("time"), number("timestep"), number("step") };
}

//------------------------------------------------------------------------------
std::vector<double> XyzComment::Numbers(std::string_view key) const
{
  std::string list = this->Find(key).value_or("");
  std::vector<double> numbers;
  for (const std::string_view item : ListItems(list))
  {
    numbers.push_back(NumberOf(item).value_or(NAN));
  }
  return numbers;
}

//------------------------------------------------------------------------------
std::optional<SimulationCell> XyzComment::Cell() const
{
  const auto refuse = [&](const char* key, const char* expected)
  {
    const std::string value = *this->Find(key);
    throw ContentError(std::string("found ") + Quote(value.data(), value.data() + value.size()) +
      " as " + key + ", expected " + expected);
  };
  const auto allFinite = [](const std::vector<double>& numbers)
  {
    return std::all_of(
      numbers.begin(), numbers.end(), [](double value) { return std::isfinite(value); });
  };
  if (!this->Find("lattice"))
  {
    return std::nullopt;
  }
  SimulationCell cell{};
  const std::vector<double> vectors = this->Numbers("lattice");
  if (vectors.size() != 9 || !allFinite(vectors))
  {
    refuse("lattice", "nine numbers");
  }
  for (int i = 0; i < 9; ++i)
  {
    cell.Vectors[i / 3][i % 3] = vectors[i];
  }
  if (this->Find("origin"))
  {
    const std::vector<double> origin = this->Numbers("origin");
    if (origin.size() != 3 || !allFinite(origin))
    {
      refuse("origin", "three numbers");
    }
    std::copy_n(origin.begin(), 3, cell.Origin);
  }
  if (auto flags = this->Find("pbc"))
  {
    const Fields items = ListItems(*flags);
    const auto isFlag = [](std::string_view item)
    { return std::string_view("TtFf10").find(item.front()) != std::string_view::npos; };
    if (items.size() != 3 || !std::all_of(items.begin(), items.end(), isFlag))
    {
      refuse("pbc", "T or F for each of three axes");
    }
    std::transform(items.begin(), items.end(), cell.Periodic.begin(), [](std::string_view item)
      { return std::string_view("Tt1").find(item.front()) != item.npos; });
  }
  return cell;
}
}
