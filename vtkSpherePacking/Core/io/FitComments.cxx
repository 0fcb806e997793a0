// SPDX-License-Identifier: BSD-3-Clause
#include "io/FitComments.h"

#include "io/NameMeaning.h"
#include "io/UnitsOfRemark.h"

#include <algorithm>
#include <charconv>
#include <cstddef>
#include <optional>
#include <set>
#include <string>

namespace spherepacking
{
namespace
{
constexpr std::string_view Blanks = " \t";

std::string_view Trim(std::string_view text)
{
  const std::size_t first = std::min(text.find_first_not_of(Blanks), text.size());
  return text.substr(first, text.find_last_not_of(Blanks) + 1 - first);
}

/// A comment that may name one column.
struct OneName
{
  std::string_view Name;
  vtkIdType Line;
  std::optional<std::size_t> Number;
  bool NamesSphere = false;
  enum Kind
  {
    Remark,
    Unclear, ///< two words, which may be a name
    Column   ///< a word, a name of two, or any after "column"
  };
  Kind Is = Remark;
};

// "2" and ": y [mm]" of "column 2: y [mm]".
std::optional<std::size_t> TakeNumber(std::string_view& text, bool& labelled)
{
  for (const std::string_view label : { "column", "Column", "col", "Col", "field", "Field" })
  {
    if (text.substr(0, label.size()) == label &&
      text.find_first_of(" \t0123456789", label.size()) == label.size())
    {
      text = Trim(text.substr(label.size()));
      labelled = true;
      break;
    }
  }
  std::size_t number = 0;
  const std::size_t bracket = !text.empty() && (text[0] == '[' || text[0] == '(') ? 1 : 0;
  const auto [end, error] =
    std::from_chars(text.data() + bracket, text.data() + text.size(), number);
  if (error != std::errc())
  {
    return std::nullopt;
  }
  text = Trim(text.substr(end - text.data()));
  if (!text.empty() && std::string_view(":.)]=-").find(text.front()) != std::string_view::npos)
  {
    text = Trim(text.substr(1));
  }
  return number;
}

// The name may have an explanation after it: "x: position in mm", "r (mm)", "radius of the sphere".
OneName ReadOneName(const TextRange& comment)
{
  std::string_view text = View(comment);
  text = Trim(text.substr(std::min(text.find_first_not_of('#'), text.size())));
  OneName one;
  one.Line = comment.FirstLine;
  bool labelled = false;
  one.Number = TakeNumber(text, labelled);
  one.Name = text;
  if (text.find('=') != text.npos)
  {
    return one; // "r = 0.5" gives a value, not a name
  }
  const std::size_t mark = std::min({ text.find_first_of(":,;"), text.find(" - "), text.size() });
  const std::size_t word = std::min(text.find_first_of(" \t:,;"), text.size());
  for (const std::size_t length : { mark, text.size(), word })
  {
    const std::string_view name = Trim(text.substr(0, length));
    const bool value = text.substr(length).find_first_of("0123456789") != text.npos;
    if (!value && IsOfSphere(MeaningOfName(name)))
    {
      one.Name = name;
      one.NamesSphere = true;
      break;
    }
  }
  const std::string_view name = Trim(text.substr(0, std::min(mark, text.find_first_of("(["))));
  const std::size_t blank = std::min(name.find_first_of(Blanks), name.size());
  const std::string_view second = Trim(name.substr(blank));
  const bool value = text.substr(mark).find_first_of("0123456789") != text.npos;
  const bool two = second.find_first_of(Blanks) == second.npos;
  const bool known = second.empty() || IsNameOfTwoWords(name.substr(0, blank), second) ||
    one.NamesSphere || labelled;
  one.Is = one.NamesSphere || labelled || (!name.empty() && !value && known) ? OneName::Column
    : !name.empty() && !value && two                                         ? OneName::Unclear
                                                                             : OneName::Remark;
  return one;
}

// The names of the comments [first, first + count), one for each column.
NamesFit FitLines(
  const std::vector<OneName>& lines, std::size_t first, std::size_t count, Radii radii)
{
  std::vector<std::string_view> names;
  for (std::size_t i = first; i < first + count; ++i)
  {
    names.push_back(lines[i].Name);
  }
  NamesFit fit;
  auto columns = ColumnsFromNames(names, fit.Complaint, radii);
  if (columns && fit.Complaint.empty())
  {
    fit.What = NamesFit::Fits;
    fit.Columns = std::move(*columns);
  }
  else
  {
    fit.What = columns ? NamesFit::Unclear : NamesFit::NoNames;
  }
  return fit;
}

// Comments with numbers that count up: "column 1: id", "column 2: x".
NamesFit FitNumberedLines(const std::vector<OneName>& lines, std::size_t count, Radii radii)
{
  for (std::size_t first = 0; first < lines.size(); ++first)
  {
    if (!lines[first].Number || *lines[first].Number > 1)
    {
      continue;
    }
    std::size_t last = first + 1;
    while (last < lines.size() && lines[last].Number == *lines[last - 1].Number + 1)
    {
      ++last;
    }
    NamesFit fit = FitLines(lines, first, last - first, radii);
    const auto namesSphere = [](const OneName& line) { return line.NamesSphere; };
    if (fit.What != NamesFit::NoNames ||
      (last - first > 1 && std::any_of(lines.begin() + first, lines.begin() + last, namesSphere)))
    {
      fit.What = last - first == count ? fit.What : NamesFit::Unclear;
      return fit;
    }
    first = last - 1;
  }
  return {};
}

// As many comments in turn as there are columns, each with a name, and all of the sphere among
// them.
NamesFit FitPlainLines(const std::vector<OneName>& lines, std::size_t count, Radii radii)
{
  NamesFit fit;
  std::vector<std::string_view> names; // of the sphere, in all lines
  std::size_t fitting = 0;
  for (std::size_t first = 0, last = 0; first < lines.size(); first = last)
  {
    const auto follows = [&](std::size_t i)
    {
      const bool remark = lines[i].Is == OneName::Remark || lines[first].Is == OneName::Remark;
      return i == first || (!remark && lines[i].Line == lines[i - 1].Line + 1);
    };
    std::size_t here = 0;
    bool clear = true;
    for (last = first; last < lines.size() && follows(last); ++last)
    {
      clear &= lines[last].Is == OneName::Column;
      if (lines[last].NamesSphere)
      {
        names.push_back(lines[last].Name);
        ++here;
      }
    }
    if (here > 0 && clear && last - first == count)
    {
      fit = FitLines(lines, first, count, radii);
      fitting = here;
    }
  }
  if (fit.What == NamesFit::Fits && fitting == names.size())
  {
    return fit;
  }
  fit = {};
  fit.What = NamesSomeOfSphere(names, count) ? NamesFit::Unclear : NamesFit::NoNames;
  return fit;
}

// Whether the comments that name the sphere, one each, speak of several units of length.
bool HaveTwoUnits(const TableHead& head, const std::vector<OneName>& lines)
{
  std::set<std::string> units;
  for (std::size_t i = 0; i < lines.size(); ++i)
  {
    if (lines[i].NamesSphere)
    {
      units.merge(UnitsOfRemark(View(head.Comments[i])));
    }
  }
  return units.size() > 1;
}
}

//------------------------------------------------------------------------------
CommentFit FitComments(const TableHead& head, std::size_t count, Radii radii)
{
  CommentFit unclear;
  for (auto comment = head.Comments.rbegin(); comment != head.Comments.rend(); ++comment)
  {
    CommentFit fit{ FitNames(View(*comment), count, radii), *comment, false };
    if (fit.What == NamesFit::Fits)
    {
      return fit;
    }
    if (fit.What == NamesFit::Unclear && unclear.What == NamesFit::NoNames)
    {
      unclear = std::move(fit);
    }
  }
  std::vector<OneName> lines;
  for (const TextRange& comment : head.Comments)
  {
    lines.push_back(ReadOneName(comment));
  }
  for (const auto fitLines : { FitNumberedLines, FitPlainLines })
  {
    NamesFit fit = fitLines(lines, count, radii);
    if (fit.What == NamesFit::Fits && HaveTwoUnits(head, lines))
    {
      fit.What = NamesFit::Unclear;
      fit.Complaint = "found several units of length, expected one for coordinates and radii";
    }
    if (fit.What == NamesFit::Fits ||
      (fit.What == NamesFit::Unclear && unclear.What == NamesFit::NoNames))
    {
      return { std::move(fit), head.Comments.front(), true };
    }
  }
  return unclear;
}
}
