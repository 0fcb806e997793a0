// SPDX-License-Identifier: BSD-3-Clause
#include "io/NameLists.h"

#include "io/NameMeaning.h"
#include "io/SplitNames.h"
#include "io/TableLayout.h"

#include <algorithm>
#include <array>
#include <set>

namespace spherepacking
{
namespace
{
using Names = std::vector<std::string_view>;
using Words = std::set<std::string_view>;

bool IsLetter(char c)
{
  return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z');
}

// Drops what only stands between names.
void DropAnd(Names& words)
{
  const auto isBetween = [](std::string_view word)
  { return word == "and" || word.find_first_not_of(":|&-") == word.npos; };
  words.erase(std::remove_if(words.begin(), words.end(), isBetween), words.end());
}

// Whether the words are a sentence, or give values.
bool IsSentence(const Names& words)
{
  static const Words sentence{ "the", "of", "in", "is", "are", "an", "with", "for", "by", "at",
    "from", "to", "their", "its", "or", "on", "The", "In", "=" };
  return std::any_of(words.begin(), words.end(),
    [](std::string_view word)
    {
      return sentence.count(word) > 0 || IsNumber(word) ||
        (word.size() > 1 && word.find('=') != word.npos);
    });
}

// Whether a word is a usual name of a column, or as short as a symbol.
bool IsNameLike(std::string_view word)
{
  static const Words usual{ "lat", "lon", "lng", "latitude", "longitude", "rho", "mass", "time",
    "type", "density", "volume", "charge", "material", "label", "velocity", "height", "depth",
    "row", "col", "column", "slice", "layer" };
  const bool letters = std::all_of(word.begin(), word.end(), IsLetter);
  const bool ofAxis = word.size() > 2 && (word[1] == '-' || word[1] == '_') &&
    std::string_view("xyzXYZ").find(word[0]) != std::string_view::npos;
  return MeaningOfName(word).What != NameMeaning::Other || usual.count(word) > 0 ||
    IsIdName(word) || (letters && word.size() <= 2) || ofAxis;
}

// The line with xyz in place of "(x, y, z)".
std::string JoinAxes(std::string_view line)
{
  constexpr std::size_t longest =
    80; // so that brackets that do not close take no more time than others
  for (std::size_t at = line.find('('); at != line.npos; at = line.find('(', at + 1))
  {
    const std::size_t end = BracketEnd(line.substr(0, at + longest), at);
    const Names axes =
      end == at ? Names() : SplitNames(line.substr(at + 1, end - at - 1), Between::Anything);
    const bool all =
      axes.size() == 3 && (axes == Names{ "x", "y", "z" } || axes == Names{ "X", "Y", "Z" });
    if (all)
    {
      return std::string(line.substr(0, at)) + " xyz " + std::string(line.substr(end + 1));
    }
  }
  return std::string(line);
}
}

//------------------------------------------------------------------------------
bool IsIdName(std::string_view name)
{
  static const Words ids{ "id", "ID", "Id", "ids", "index", "Index", "i", "n", "no", "No", "nr",
    "Nr", "number", "Number", "type", "Type", "tag", "material", "element", "name" };
  return ids.count(name) > 0;
}

//------------------------------------------------------------------------------
bool ListOtherColumns(Names words, std::size_t count)
{
  DropAnd(words);
  const bool fewer = words.size() < count;
  if (words.size() > count || (fewer && words.size() < 4) || IsSentence(words))
  {
    return false;
  }
  std::array<bool, 3> axes{};
  bool size = false;
  for (const std::string_view word : words)
  {
    const NameMeaning meaning = MeaningOfName(word);
    if (meaning.What == NameMeaning::Coordinate)
    {
      axes[meaning.Axis] = true;
    }
    size |= meaning.What == NameMeaning::Radius || meaning.What == NameMeaning::Diameter;
  }
  const auto named = std::count(axes.begin(), axes.end(), true);
  return named == 3 ? !size && !fewer
                    : (named > 0 || size) && std::all_of(words.begin(), words.end(), IsNameLike);
}

//------------------------------------------------------------------------------
SpelledNames SpellPosition(std::string_view line)
{
  const std::string joined = JoinAxes(WithoutLabelWord(WithoutLabel(WithoutSigns(line))));
  Names words = SplitNames(joined, Between::Anything);
  DropAnd(words);
  SpelledNames spelled;
  const auto position = std::find_if(words.begin(), words.end(), IsPosition);
  if (position == words.end() || IsSentence(words))
  {
    return spelled;
  }
  auto after = position + 1;
  after += after != words.end() && IsPosition(*after) ? 1 : 0; // position (x, y, z)
  const auto isAxis = [](std::string_view word)
  { return MeaningOfName(word).What == NameMeaning::Coordinate || IsPosition(word); };
  const auto isSize = [](std::string_view word)
  {
    const NameMeaning meaning = MeaningOfName(word);
    return meaning.What == NameMeaning::Radius || meaning.What == NameMeaning::Diameter;
  };
  const bool otherNames = position == words.begin() && after != words.end() &&
    std::all_of(after, words.end(), IsNameLike);
  if (std::any_of(words.begin(), position, isAxis) || std::any_of(after, words.end(), isAxis) ||
    (!otherNames && std::none_of(words.begin(), words.end(), isSize)))
  {
    return spelled;
  }
  spelled.IsClear = std::all_of(words.begin(), position, IsIdName);
  spelled.RadiusFollows = after != words.end() &&
    MeaningOfName(*after).What == NameMeaning::Radius &&
    std::none_of(words.begin(), position, IsIdName);
  spelled.Names.assign(words.begin(), position);
  spelled.Names.insert(spelled.Names.end(), { "x", "y", "z" });
  spelled.Names.insert(spelled.Names.end(), after, words.end());
  return spelled;
}
}
