// SPDX-License-Identifier: BSD-3-Clause
#include "io/SizeComponents.h"

#include "io/NameMeaning.h"
#include "io/Number.h"
#include "io/PackingFileError.h"
#include "io/TableRows.h"

#include <algorithm>

namespace spherepacking
{
namespace
{
bool IsSize(std::string_view name)
{
  const NameMeaning meaning = MeaningOfName(name);
  return meaning.What == NameMeaning::Radius || meaning.What == NameMeaning::Diameter;
}

// Whether `name` is that of component `number` of `stem`: radius_0 or, in older files, radius:0.
bool IsComponent(std::string_view name, std::string_view stem, char number)
{
  return name.size() == stem.size() + 2 && name.substr(0, stem.size()) == stem &&
    (name[stem.size()] == '_' || name[stem.size()] == ':') && name.back() == number;
}
}

//------------------------------------------------------------------------------
std::optional<std::size_t> FindSizeComponents(const std::vector<std::string_view>& names)
{
  std::optional<std::size_t> first;
  for (std::size_t i = 0; i < names.size(); ++i)
  {
    if (IsSize(names[i]))
    {
      return std::nullopt;
    }
    const std::string_view stem = names[i].substr(0, std::max<std::size_t>(names[i].size(), 2) - 2);
    if (!first && i + 2 < names.size() && IsSize(stem) && IsComponent(names[i], stem, '0') &&
      IsComponent(names[i + 1], stem, '1') && IsComponent(names[i + 2], stem, '2'))
    {
      first = i;
    }
  }
  return first;
}

//------------------------------------------------------------------------------
void CheckSizeComponents(const TextRange& rows, const Separators& between, std::size_t first)
{
  ForRows(rows,
    [&](const TextRange& row)
    {
      const auto fields = between.Split(row.Begin);
      const auto differs = [&](std::size_t i)
      {
        double a = 0.0;
        double b = 0.0;
        ParseNumber(fields[first].data(), fields[first].data() + fields[first].size(), a);
        const char* const end = fields[i].data() + fields[i].size();
        return ParseNumber(fields[i].data(), end, b) != end || a != b;
      };
      if (fields.size() > first + 2 && (differs(first + 1) || differs(first + 2)))
      {
        throw LineError(row.FirstLine,
          "found a radius of different components in " + Quote(row.Begin, row.End) +
            ", expected three that are equal, or one");
      }
      return true;
    });
}
}
