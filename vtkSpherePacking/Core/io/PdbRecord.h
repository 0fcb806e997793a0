// SPDX-License-Identifier: BSD-3-Clause
#ifndef PdbRecord_h
#define PdbRecord_h

#include "io/TextLines.h"

#include <cstddef>
#include <string_view>

/// Lines of files that are laid out as those of the Protein Data Bank: wwPDB, "Protein Data Bank
/// Contents Guide: Atomic Coordinate Entry Format Description", version 3.3, 2012.
namespace spherepacking
{
inline bool IsLetter(char c)
{
  return (c >= 'A' && c <= 'Z') || (c >= 'a' && c <= 'z');
}

inline bool IsDigit(char c)
{
  return c >= '0' && c <= '9';
}

/// Whether a line begins with `record` (in capitals), in any letter case and perhaps after blanks,
/// and no further letter follows. Numbers of 5 digits touch their record. `*end` must be a line
/// end, but may be that of a later line.
inline bool BeginsWithRecord(const char* begin, const char* end, std::string_view record)
{
  const char* p = SkipBlanks(begin, end);
  for (const char capital : record)
  {
    if (*p != capital && *p != capital - 'A' + 'a')
    {
      return false;
    }
    ++p;
  }
  return !IsLetter(*p);
}

inline bool IsAtomRecord(const char* begin, const char* end)
{
  return BeginsWithRecord(begin, end, "ATOM") || BeginsWithRecord(begin, end, "HETATM");
}

/// The columns `first` to `last` of a line, counted from 1 as in the guide, without blanks around;
/// empty where the line is shorter.
inline std::string_view PdbColumns(std::string_view line, std::size_t first, std::size_t last)
{
  if (line.size() < first)
  {
    return {};
  }
  std::string_view field = line.substr(first - 1, last - first + 1);
  while (!field.empty() && IsBlank(field.front()))
  {
    field.remove_prefix(1);
  }
  while (!field.empty() && IsBlank(field.back()))
  {
    field.remove_suffix(1);
  }
  return field;
}

/// Whether the columns `first` to `last` hold a number with `decimals` decimals that ends in the
/// last of them, as Fortran's F edit descriptor writes it.
inline bool HoldsFixedNumber(
  std::string_view line, std::size_t first, std::size_t last, std::size_t decimals)
{
  if (line.size() < last)
  {
    return false;
  }
  const char* const end = line.data() + last;
  const char* const dot = end - decimals - 1;
  const char* p = SkipBlanks(line.data() + first - 1, dot);
  p += p != dot && (*p == '-' || *p == '+');
  for (; p != end; ++p)
  {
    if (p == dot ? *p != '.' : !IsDigit(*p))
    {
      return false;
    }
  }
  return true;
}

/// Whether x, y and z stand in the columns that the guide gives them, 31 to 54, F8.3 each, where
/// they may touch.
inline bool HoldsCoordinates(std::string_view line)
{
  return line.size() >= 54 && IsBlank(line[29]) && HoldsFixedNumber(line, 31, 38, 3) &&
    HoldsFixedNumber(line, 39, 46, 3) && HoldsFixedNumber(line, 47, 54, 3);
}

/// Whether two numbers stand after them as the guide has occupancy and temperature factor, 55 to 60
/// and 61 to 66, F6.2 each.
inline bool HoldsOccupancy(std::string_view line)
{
  return HoldsCoordinates(line) && HoldsFixedNumber(line, 55, 60, 2) &&
    HoldsFixedNumber(line, 61, 66, 2);
}

/// Whether an element stands where the guide has it, right-justified in the columns 77 and 78.
inline bool HoldsElement(std::string_view line)
{
  return line.size() >= 78 && IsLetter(line[77]) && (IsLetter(line[76]) || line[76] == ' ');
}
}

#endif
