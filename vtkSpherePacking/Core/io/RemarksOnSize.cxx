// SPDX-License-Identifier: BSD-3-Clause
#include "io/RemarksOnSize.h"

#include "io/DiameterWords.h"
#include "io/NamelessColumns.h"
#include "io/PackingFileError.h"
#include "io/RemarksOnOrder.h"
#include "io/TableHead.h"
#include "io/UnitsOfRemark.h"

#include <algorithm>
#include <set>
#include <string>

namespace spherepacking
{
namespace
{
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
void CheckOrder(const TextRange& remark, std::size_t count)
{
  if (SpeaksOfOtherOrder(View(remark)))
  {
    throw LineError(remark.FirstLine,
      "found " + Quote(remark.Begin, remark.End) +
        ", which may speak of another order than x y z radius, beside rows without certain names, "
        "expected " +
        HintFor(count));
  }
}

//------------------------------------------------------------------------------
void CheckRemarks(const std::vector<TextRange>& remarks, std::size_t count)
{
  std::set<std::string> units;
  for (const TextRange& remark : remarks)
  {
    CheckNoDiameter(remark, count);
    if (SpeaksOfOtherSize(View(remark)))
    {
      throw LineError(remark.FirstLine,
        "found " + Quote(remark.Begin, remark.End) +
          ", which may say that the fourth column is no radius, beside rows without certain names, "
          "expected " +
          HintFor(count));
    }
    units.merge(UnitsOfRemark(View(remark)));
    if (units.size() > 1)
    {
      throw LineError(remark.FirstLine,
        "found " + Quote(remark.Begin, remark.End) + " and so the units of length " +
          *units.begin() + " and " + *units.rbegin() +
          ", expected one for coordinates and radii, or " + HintFor(count));
    }
  }
}
}
