// SPDX-License-Identifier: BSD-3-Clause
#include "io/DecimalCommas.h"

#include "io/TableLayout.h"
#include "io/TextLines.h"

#include <cstddef>
#include <string>

namespace spherepacking
{
//------------------------------------------------------------------------------
bool HasDecimalCommas(std::string_view row)
{
  bool bareComma = false;
  bool other = false;
  const auto at = [row](std::size_t i) { return i < row.size() ? row[i] : ' '; };
  const auto digitAt = [at](std::size_t i) { return at(i) >= '0' && at(i) <= '9'; };
  for (std::size_t i = 0; i < row.size() && row[i] != '#'; ++i)
  {
    if (row[i] == '.')
    {
      return false;
    }
    bareComma |= row[i] == ',' && digitAt(i - 1) && digitAt(i + 1);
    const bool beforeNumber = digitAt(i + 1) || at(i + 1) == '-' || at(i + 1) == '+';
    other |= row[i] == ';' || (IsBlank(row[i]) && beforeNumber);
  }
  return bareComma && other;
}

//------------------------------------------------------------------------------
bool IsDecimalComma(std::string_view field)
{
  const std::size_t comma = field.find(',');
  if (comma == field.npos || comma == 0 || field.find('.') != field.npos)
  {
    return false;
  }
  std::string number(field);
  number[comma] = '.';
  return IsNumber(number);
}
}
