// SPDX-License-Identifier: BSD-3-Clause
#include "io/UnitsBesideNames.h"

#include "io/FitNames.h"
#include "io/NameMeaning.h"
#include "io/NamelessColumns.h"
#include "io/PackingFileError.h"
#include "io/SplitNames.h"
#include "io/TableHead.h"
#include "io/UnitsOfRemark.h"

#include <algorithm>
#include <cstddef>
#include <set>
#include <string>

namespace spherepacking
{
namespace
{
// What is in the brackets around a field, or the field.
std::string_view WithoutBrackets(std::string_view field)
{
  field = Trim(field);
  const bool bracket = field.size() > 2 && (field[0] == '[' || field[0] == '(') &&
    BracketEnd(field, 0) == field.size() - 1;
  return bracket ? Trim(field.substr(1, field.size() - 2)) : field;
}

// The words of a remark, with brackets as they are.
std::vector<std::string_view> WordsOf(std::string_view remark)
{
  std::vector<std::string_view> words;
  remark = WithoutLabel(WithoutSigns(remark));
  for (std::size_t p = 0; p < remark.size();)
  {
    const std::size_t begin = std::min(remark.find_first_not_of(" \t,;|", p), remark.size());
    const std::size_t end = std::min(remark.find_first_of(" \t,;|", begin), remark.size());
    if (end > begin)
    {
      words.push_back(remark.substr(begin, end - begin));
    }
    p = end;
  }
  return words;
}

[[noreturn]] void ThrowUnits(const TextRange& line, std::size_t count)
{
  throw LineError(line.FirstLine,
    "found several units of length in " + Quote(line.Begin, line.End) +
      ", expected one for coordinates and radii, or " + HintFor(count));
}
}

//------------------------------------------------------------------------------
bool AreUnits(const std::vector<std::string_view>& fields)
{
  int lengths = 0;
  for (const std::string_view field : fields)
  {
    const std::string_view unit = WithoutBrackets(field);
    const bool length = !UnitInBracket(unit).empty();
    if (!length && unit != "-" && !IsUnit(unit))
    {
      return false;
    }
    lengths += length ? 1 : 0;
  }
  return lengths > 2;
}

//------------------------------------------------------------------------------
void CheckUnitsOfColumns(const TextRange& line, const std::vector<std::string_view>& fields,
  const std::vector<Column>& columns)
{
  std::set<std::string> units;
  for (std::size_t i = 0; i < columns.size() && i < fields.size(); ++i)
  {
    if (columns[i].Role <= ColumnRole::Diameter)
    {
      const std::string ofName = MeaningOfName(columns[i].Name).Unit;
      units.insert(UnitInBracket(WithoutBrackets(fields[i])));
      if (!ofName.empty())
      {
        units.insert(ofName);
      }
    }
  }
  if (units.size() > 1)
  {
    ThrowUnits(line, columns.size());
  }
}

//------------------------------------------------------------------------------
void CheckUnitsOfRemarks(const std::vector<TextRange>& remarks, const std::vector<Column>& columns)
{
  for (const TextRange& remark : remarks)
  {
    const std::vector<std::string_view> words = WordsOf(View(remark));
    if (words.size() == columns.size() && AreUnits(words))
    {
      CheckUnitsOfColumns(remark, words, columns);
    }
    else if (UnitsOfRemark(View(remark)).size() > 1 &&
      FitNames(View(remark), columns.size(), Radii::Optional).What != NamesFit::Fits)
    {
      ThrowUnits(remark, columns.size());
    }
  }
}
}
