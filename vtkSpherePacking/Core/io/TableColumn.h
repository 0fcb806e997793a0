// SPDX-License-Identifier: BSD-3-Clause
#ifndef TableColumn_h
#define TableColumn_h

#include <string>

namespace spherepacking
{
/// What a column of a table holds.
enum class ColumnRole : unsigned char
{
  X,
  Y,
  Z,
  Radius,
  Diameter,
  Extra,  ///< further numbers, which become a point array
  Text,   ///< anything else, which becomes a point array of strings
  Skipped ///< what nobody wants
};

struct Column
{
  ColumnRole Role;
  std::string Name;
};
}

#endif
