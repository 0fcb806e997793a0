// SPDX-License-Identifier: BSD-3-Clause
#include "io/RemarksOnSize.h"

#include "io/DiameterWords.h"
#include "io/NameMeaning.h"
#include "io/NamelessColumns.h"
#include "io/PackingFileError.h"
#include "io/TableHead.h"

#include <algorithm>
#include <set>
#include <string>
#include <string_view>

namespace spherepacking
{
namespace
{
bool IsLetter(char c)
{
  return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || c < 0;
}

// x y z SIZE and a - for each further column, as columns= takes them.
std::string ColumnsWith(const char* size, std::size_t count)
{
  constexpr std::size_t most = 12;
  std::string columns = std::string("columns=\"x y z ") + size;
  for (std::size_t i = 4; i < std::min(count, most); ++i)
  {
    columns += " -";
  }
  return columns + (count > most ? " ...\"" : "\"");
}

// The units of length in a remark on places or sizes, but for those behind numbers, as in "10 cm".
// An m may be a mass: it is a unit in a bracket, behind "in" or right behind a name.
std::set<std::string> UnitsOfRemark(std::string_view remark)
{
  std::set<std::string> units;
  bool onSpheres = false;
  std::string_view before;
  for (std::size_t p = 0; p < remark.size();)
  {
    std::size_t end = p;
    while (end < remark.size() && IsLetter(remark[end]))
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
    const std::string unit = LengthUnit(word);
    if (!unit.empty() && !value && (said || unit != "m"))
    {
      units.insert(unit);
    }
    onSpheres |= IsOfSphere(MeaningOfName(word)) || IsPosition(word);
    before = word;
    p = end;
  }
  return onSpheres ? units : std::set<std::string>();
}
}

//------------------------------------------------------------------------------
void CheckNoDiameter(const TextRange& remark, std::size_t count)
{
  if (SpeaksOfDiameter(View(remark)))
  {
    throw LineError(remark.FirstLine,
      "found " + Quote(remark.Begin, remark.End) +
        ", which may speak of diameters, beside rows without certain names, expected " +
        ColumnsWith("d", count) + " or " + ColumnsWith("r", count) + " (--columns) to say which");
  }
}

//------------------------------------------------------------------------------
void CheckRemarks(const std::vector<TextRange>& remarks, std::size_t count)
{
  std::set<std::string> units;
  for (const TextRange& remark : remarks)
  {
    CheckNoDiameter(remark, count);
    units.merge(UnitsOfRemark(View(remark)));
    if (units.size() > 1)
    {
      throw LineError(remark.FirstLine,
        "found " + Quote(remark.Begin, remark.End) + " and so the units of length " +
          *units.begin() + " and " + *units.rbegin() +
          ", expected one for coordinates and radii, or " + ColumnsHint);
    }
  }
}
}
