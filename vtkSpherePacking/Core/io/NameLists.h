// SPDX-License-Identifier: BSD-3-Clause
#ifndef NameLists_h
#define NameLists_h

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

namespace spherepacking
{
/// Whether a name is that of a number or kind that programs put before a sphere, such as id.
bool IsIdName(std::string_view name);

/// Whether as many words as there are columns, or four and more, seem to be their names, and say
/// that the columns are not x, y, z and radius: x, y and z with no size, or without all three. A
/// sentence is no list.
bool ListOtherColumns(std::vector<std::string_view> words, std::size_t count);

/// Names of columns in which one name, such as position, stood for three.
struct SpelledNames
{
  std::vector<std::string> Names; ///< x, y and z in its place; empty if there is no such name
  bool IsClear = false;           ///< nothing but ids stands before it
  bool RadiusFollows = false;     ///< right behind it, as in rows that nobody names
};

/// Spells the coordinates in `line`, which has "position", "xyz" or "(x, y, z)" among its names and
/// that of a size or nothing but usual names; a sentence is no list.
SpelledNames SpellPosition(std::string_view line);
}

#endif
