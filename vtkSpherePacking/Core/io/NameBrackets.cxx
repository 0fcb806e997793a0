// SPDX-License-Identifier: BSD-3-Clause
#include "io/NameBrackets.h"

#include "io/NameMeaning.h"
#include "io/SplitNames.h"
#include "io/TableLayout.h"

#include <algorithm>
#include <iterator>
#include <set>

namespace spherepacking
{
namespace
{
using Words = std::set<std::string_view>;

std::string ToLower(std::string_view text)
{
  std::string lower;
  std::transform(text.begin(), text.end(), std::back_inserter(lower),
    [](char c) { return c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c; });
  return lower;
}

bool IsAnyOf(const Words& words, std::string_view text)
{
  return words.count(text) > 0;
}

bool IsSize(const NameMeaning& meaning)
{
  return meaning.What == NameMeaning::Radius || meaning.What == NameMeaning::Diameter;
}
}

//------------------------------------------------------------------------------
std::vector<NameBracket> FindBrackets(std::string_view line)
{
  std::vector<NameBracket> brackets;
  for (std::size_t at = line.find_first_of("(["); at != line.npos;)
  {
    const std::size_t end = BracketEnd(line, at);
    std::string_view before = line.substr(0, at);
    before = before.substr(0, before.find_last_not_of(" \t") + 1);
    const std::size_t word = before.find_last_of(" \t,;:)]");
    NameBracket bracket;
    bracket.Name = before.substr(word == before.npos ? 0 : word + 1);
    bracket.Text = Trim(line.substr(at + 1, end > at ? end - at - 1 : 0));
    bracket.Before = before.size();
    bracket.End = end + 1;
    brackets.push_back(bracket);
    at = end > at ? line.find_first_of("([", end) : line.npos;
  }
  return brackets;
}

//------------------------------------------------------------------------------
bool IsPlainBracket(std::string_view text)
{
  static const Words units{ "-", "--", "\xE2\x80\x93", "\xE2\x80\x94", "1", "l", "lj", "lj units",
    "lu", "l.u.", "sigma", "\xCF\x83", "si", "si units", "a.u.", "arb. u.", "arb. units",
    "arbitrary units", "units", "unit", "unit length", "length", "length units", "reduced units",
    "simulation units", "code units", "model units", "lattice units", "dimensionless", "none",
    "float", "double", "real", "number", "float32", "float64", "f4", "f8", "mean", "average" };
  static const Words of{ "equivalent", "equiv", "equiv.", "eq", "eq.", "effective", "eff", "eff.",
    "inscribed", "sphere", "spheres", "spherical", "particle", "particles", "grain", "grains",
    "ball", "balls", "bead", "beads", "atom", "atoms", "atomic", "pore", "pores", "bubble",
    "bubbles", "droplet", "droplets", "vdw", "of", "a", "the", "each" };
  const std::string lower = ToLower(Trim(text));
  if (lower.empty() || IsAnyOf(units, lower))
  {
    return true;
  }
  const std::vector<std::string_view> words = SplitNames(lower, Between::Anything);
  return std::all_of(words.begin(), words.end(), [](auto word) { return IsAnyOf(of, word); });
}

//------------------------------------------------------------------------------
bool IsNoLength(std::string_view text)
{
  static const Words words{ "squared", "square", "sq", "sqr", "sqrt", "root", "cubed", "cube",
    "inverse", "inverted", "reciprocal", "exp", "percent", "per", "normalized", "normalised",
    "norm", "norm.", "relative", "rel", "rel.", "ratio", "fraction", "fractional", "scaled",
    "standardized", "standardised", "ranked", "rank", "index", "volume", "area", "curvature", "ln",
    "lg", "log", "log2", "log10", "logarithm", "logarithmic" };
  const std::string lower = ToLower(text);
  const auto begins = [](std::string_view word, std::string_view part)
  { return word.substr(0, part.size()) == part; };
  if (lower.find('%') != lower.npos || begins(lower, "1/") ||
    lower.find("\xC2\xB2") != lower.npos || lower.find("\xC2\xB3") != lower.npos)
  {
    return true;
  }
  for (std::size_t p = 0; p < lower.size();)
  {
    const std::size_t begin = std::min(lower.find_first_not_of(" \t,;:_-/()[]=", p), lower.size());
    const std::size_t end = std::min(lower.find_first_of(" \t,;:_-/()[]=", begin), lower.size());
    const std::string_view word = std::string_view(lower).substr(begin, end - begin);
    const bool power = word.size() > 2 && (word.substr(1) == "^2" || word.substr(1) == "^3");
    if (power || IsAnyOf(words, word))
    {
      return true;
    }
    p = end;
  }
  return false;
}

//------------------------------------------------------------------------------
bool IsScaled(std::string_view text)
{
  const std::string lower = ToLower(Trim(text));
  const bool digits = lower.find_first_of("0123456789") != lower.npos;
  const bool times = lower.find_first_of("^*") != lower.npos ||
    lower.find("\xC3\x97") != lower.npos || lower.find("\xC2\xB7") != lower.npos;
  const bool letter = lower.size() > 1 && lower[0] == 'x' &&
    lower.find_first_of("0123456789", 1) == std::min(lower.find_first_not_of(' ', 1), lower.size());
  return digits && (times || letter);
}

//------------------------------------------------------------------------------
std::string_view FindUnclearBracket(std::string_view line)
{
  const std::vector<NameBracket> brackets = FindBrackets(line);
  std::set<std::string_view> ofPlaces;
  std::set<std::string_view> ofSizes;
  for (const NameBracket& bracket : brackets)
  {
    const NameMeaning meaning = MeaningOfName(bracket.Name);
    if (meaning.What == NameMeaning::Coordinate || IsPosition(bracket.Name))
    {
      ofPlaces.insert(bracket.Text);
    }
    else if (IsSize(meaning))
    {
      ofSizes.insert(bracket.Text);
    }
  }
  for (const NameBracket& bracket : brackets)
  {
    const bool place = ofPlaces.count(bracket.Text) > 0;
    const bool size = ofSizes.count(bracket.Text) > 0;
    const NameMeaning meaning = MeaningOfName(bracket.Name);
    const bool behindSize = IsSize(meaning);
    const bool behindPlace = meaning.What == NameMeaning::Coordinate || IsPosition(bracket.Name);
    const std::vector<std::string_view> words = SplitNames(bracket.Text, Between::Anything);
    const bool names = std::any_of(words.begin(), words.end(),
      [](auto word) { return IsOfSphere(MeaningOfName(word)) || IsNumber(word); });
    if ((!behindSize && !behindPlace) || !UnitInBracket(bracket.Text).empty())
    {
      continue;
    }
    const bool shared = place && size;
    const NameMeaning of = MeaningOfName(bracket.Text);
    const bool plain = IsSize(of) ? of.What == meaning.What : names || IsPlainBracket(bracket.Text);
    const bool unknown = behindSize && words.size() == 1 && !plain;
    if (IsNoLength(bracket.Text) || (!shared && (unknown || IsScaled(bracket.Text))))
    {
      return bracket.Text;
    }
  }
  return {};
}
}
