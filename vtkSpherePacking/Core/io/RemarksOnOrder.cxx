// SPDX-License-Identifier: BSD-3-Clause
#include "io/RemarksOnOrder.h"

#include "io/NameMeaning.h"
#include "io/RemarkWords.h"

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

/// The words of a remark, of which those nearby say what one is about.
class Remark
{
public:
  enum class Kind
  {
    Other,
    Radius,
    Place
  };

  explicit Remark(std::string_view text)
    : Text(text)
    , All(SplitRemark(text))
  {
  }

  std::size_t Count() const { return this->All.size(); }

  // An empty word outside.
  std::string_view At(std::size_t i) const
  {
    return i < this->All.size() ? std::string_view(this->All[i].Lower) : std::string_view();
  }

  bool IsAnyOf(std::size_t i, const Words& words) const { return words.count(this->At(i)) > 0; }

  Kind KindAt(std::size_t i) const
  {
    const std::string_view word = this->At(i);
    const NameMeaning meaning = MeaningOfName(word);
    const bool place = meaning.What == NameMeaning::Coordinate || IsPosition(word) ||
      word == "coords" || word == "xyz";
    return word.empty()                     ? Kind::Other
      : meaning.What == NameMeaning::Radius ? Kind::Radius
      : place                               ? Kind::Place
                                            : Kind::Other;
  }

  // Whether words i and i + 1 are parts of one clause.
  bool Joined(std::size_t i) const
  {
    if (i + 1 >= this->All.size())
    {
      return false;
    }
    const std::size_t end = this->All[i].End;
    return this->Text.substr(end, this->All[i + 1].Begin - end).find_first_of(",;.") ==
      std::string_view::npos;
  }

  std::string_view Behind(std::size_t i) const { return this->Text.substr(this->All[i].End); }

  // The nearest word of the sphere among some behind word i, or before it.
  Kind Nearest(std::size_t i, bool behind, bool inClause, std::size_t& distance) const
  {
    for (distance = 1; distance <= Reach; ++distance)
    {
      const std::size_t at = behind ? i + distance : i - distance;
      const std::size_t gap = behind ? at - 1 : at;
      if (at >= this->All.size() || (inClause && !this->Joined(gap)))
      {
        break;
      }
      if (const Kind kind = this->KindAt(at); kind != Kind::Other)
      {
        return kind;
      }
    }
    distance = Reach + 1;
    return Kind::Other;
  }

  Kind Nearest(std::size_t i) const
  {
    std::size_t before = 0;
    std::size_t behind = 0;
    const Kind first = this->Nearest(i, false, true, before);
    const Kind second = this->Nearest(i, true, true, behind);
    return before < behind ? first : second;
  }

private:
  static constexpr std::size_t Reach = 6;
  std::string_view Text;
  std::vector<RemarkWord> All;
};

using Kind = Remark::Kind;

// zyx, rxyz; not xyz and xyzr.
bool AreAxesInOtherOrder(std::string_view word)
{
  std::string axes(word);
  const bool sizeFirst = axes.size() == 4 && axes[0] == 'r';
  axes.erase(std::remove(axes.begin(), axes.end(), 'r'), axes.end());
  const bool inOrder = axes == "xyz";
  std::sort(axes.begin(), axes.end());
  return axes == "xyz" && word.size() <= 4 && (!inOrder || sizeFirst);
}

// "radius first", "r in the first column", "column 1 is the radius"
bool IsRadiusFirst(const Remark& remark, std::size_t i)
{
  static const Words first{ "first", "1st", "leading" };
  static const Words columns{ "column", "col", "field" };
  static const Words others{ "2", "3", "4", "three", "four", "line", "lines", "row", "rows" };
  const bool column =
    remark.IsAnyOf(i, columns) && (remark.At(i + 1) == "1" || remark.At(i + 1) == "one");
  return ((remark.IsAnyOf(i, first) && !remark.IsAnyOf(i + 1, others)) || column) &&
    remark.Nearest(i) == Kind::Radius;
}

// "radius, then the centre", "position behind the radius"
bool IsRadiusBefore(const Remark& remark, std::size_t i)
{
  static const Words before{ "then", "before", "precedes", "precede", "followed" };
  static const Words behind{ "after", "behind", "follows", "follow" };
  const bool first = remark.IsAnyOf(i, before);
  if (!first && !remark.IsAnyOf(i, behind))
  {
    return false;
  }
  std::size_t unused = 0;
  const Kind left = remark.Nearest(i, false, false, unused);
  const Kind right = remark.Nearest(i, true, false, unused);
  return first ? left == Kind::Radius && right == Kind::Place
               : left == Kind::Place && right == Kind::Radius;
}

// "squared radius", "log of r", "r^2"; not "log-normal radii".
bool IsFunctionOfRadius(const Remark& remark, std::size_t i)
{
  static const Words functions{ "squared", "square", "squares", "cubed", "cube", "log", "log2",
    "log10", "ln", "lg", "logarithm", "logarithms", "logarithmic", "inverse", "reciprocal", "sqrt",
    "root", "half", "halved", "doubled", "normalized", "normalised", "scaled", "multiplied",
    "divided" };
  const std::string_view next = remark.At(i + 1);
  if (remark.IsAnyOf(i, functions))
  {
    return next != "normal" && next != "file" && remark.Nearest(i) == Kind::Radius;
  }
  const std::string_view behind = remark.Behind(i).substr(0, 2);
  const bool power =
    behind.substr(0, 1) == "^" || behind == "**" || behind == "\xC2\xB2" || behind == "\xC2\xB3";
  return power && remark.KindAt(i) == Kind::Radius;
}

// "fourth is", "last column", "column 4"
bool IsFourthColumn(const Remark& remark, std::size_t i)
{
  static const Words columns{ "column", "col", "field", "value", "number", "entry" };
  static const Words verbs{ "is", "are", "holds", "gives", "contains", "means" };
  const bool fourth = remark.At(i) == "fourth" || remark.At(i) == "4th";
  const bool named = (fourth || remark.At(i) == "last") && remark.IsAnyOf(i + 1, columns);
  return named || (fourth && remark.IsAnyOf(i + 1, verbs)) ||
    (remark.IsAnyOf(i, columns) && i + 1 < remark.Count() && remark.At(i + 1) == "4" &&
      remark.At(i) != "number" && remark.At(i) != "value");
}
}

//------------------------------------------------------------------------------
bool SpeaksOfOtherOrder(std::string_view text)
{
  const Remark remark(text);
  for (std::size_t i = 0; i < remark.Count(); ++i)
  {
    if (AreAxesInOtherOrder(remark.At(i)) || IsRadiusFirst(remark, i) || IsRadiusBefore(remark, i))
    {
      return true;
    }
  }
  return false;
}

//------------------------------------------------------------------------------
bool SpeaksOfOtherSize(std::string_view text)
{
  const Remark remark(text);
  bool fourth = false;
  for (std::size_t i = 0; i < remark.Count(); ++i)
  {
    if (IsFunctionOfRadius(remark, i))
    {
      return true;
    }
    fourth = fourth || IsFourthColumn(remark, i);
  }
  for (std::size_t i = 0; fourth && i < remark.Count(); ++i)
  {
    fourth = remark.KindAt(i) != Kind::Radius;
  }
  return fourth;
}
}
