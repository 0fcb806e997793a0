// SPDX-License-Identifier: BSD-3-Clause
#include "io/CutFile.h"

#include "io/PackingFileError.h"
#include "io/PdbRecord.h"
#include "io/TableLayout.h"
#include "io/TextChunks.h"

#include <algorithm>
#include <cstddef>
#include <string_view>
#include <vector>

namespace spherepacking
{
namespace
{
const char* LastLine(const TextRange& text)
{
  const char* last = text.End;
  while (last != text.Begin && !IsLineEnd(last[-1]))
  {
    --last;
  }
  return last;
}

std::size_t CountDigits(std::string_view text)
{
  return std::find_if_not(text.begin(), text.end(), IsDigit) - text.begin();
}

/// How many characters a field is written with.
struct Length
{
  std::size_t Decimals = 0;
  std::size_t OfExponent = 0;
  std::size_t All = 0; ///< of what has neither
};

Length LengthOf(std::string_view field)
{
  Length length;
  if (!IsNumber(field))
  {
    length.All = field.size();
    return length;
  }
  const std::size_t point = field.find('.');
  const std::size_t exponent = field.find_first_of("eE");
  if (point != field.npos)
  {
    length.Decimals = CountDigits(field.substr(point + 1));
  }
  if (exponent != field.npos)
  {
    length.OfExponent = CountDigits(field.substr(field.find_first_of("0123456789", exponent)));
  }
  length.All = point == field.npos && exponent == field.npos ? field.size() : 0;
  return length;
}

/// Collects the fields with which one is compared.
class Longest
{
public:
  void Add(std::string_view field)
  {
    const Length length = LengthOf(field);
    this->Most.Decimals = std::max(this->Most.Decimals, length.Decimals);
    this->Most.OfExponent = std::max(this->Most.OfExponent, length.OfExponent);
    this->Most.All = std::max(this->Most.All, length.All);
  }

  bool IsAsLong(std::string_view field) const
  {
    const Length length = LengthOf(field);
    const bool isFraction = length.Decimals + length.OfExponent > 0;
    return length.Decimals >= this->Most.Decimals && length.OfExponent >= this->Most.OfExponent &&
      (isFraction || length.All >= this->Most.All) && field.back() != '.' &&
      length.OfExponent != 1; // most programs write two digits or more
  }

private:
  Length Most;
};

// Whether the row at `last`, which ends the text, may be taken for whole.
bool LooksWhole(const TextRange& rows, const char* last, const Separators& between)
{
  const std::vector<std::string_view> row = between.Split(last);
  if (row.empty())
  {
    return false;
  }
  Longest others;
  bool hasOthers = false;
  LineFinder find(last);
  for (const char* p = rows.Begin; p != last;)
  {
    const char* const end = find(p);
    const auto fields =
      IsRow(RowKind::Data, p, end) ? between.Split(p) : std::vector<std::string_view>();
    if (!fields.empty() && fields.size() == row.size())
    {
      others.Add(fields.back());
      hasOthers = true;
    }
    p = SkipLineEnd(end, last);
  }
  // A blank, a quote or a comment may follow.
  if (hasOthers && row.back().data() + row.back().size() != rows.End)
  {
    return true;
  }
  for (std::size_t i = 0; !hasOthers && i + 1 < row.size(); ++i)
  {
    if (IsNumber(row[i]))
    {
      others.Add(row[i]);
    }
  }
  return !row.back().empty() && others.IsAsLong(row.back());
}
}

//------------------------------------------------------------------------------
void CheckNotCut(const TextRange& rows, LineEnds ends, const Separators& between)
{
  const char* const last = LastLine(rows);
  const bool isRow = last != rows.End && IsRow(RowKind::Data, last, rows.End);
  if (ends == LineEnds::ByProgram ? last == rows.End : !isRow || LooksWhole(rows, last, between))
  {
    return;
  }
  throw LineError(rows.FirstLine + CountLineEnds(rows.Begin, last),
    "found the end of the file within the row " + Quote(last, rows.End) +
      ", expected a line end after every row (add one if the file is complete)");
}

//------------------------------------------------------------------------------
void CheckNotCut(const TextRange& rows)
{
  CheckNotCut(rows, LineEnds::ByProgram, Separators::Blanks());
}
}
