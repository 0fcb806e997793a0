// SPDX-License-Identifier: BSD-3-Clause
#ifndef FitNames_h
#define FitNames_h

#include "io/ColumnNames.h"

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

namespace spherepacking
{
/// What a line of names says about the columns of a table.
struct NamesFit
{
  enum Kind
  {
    NoNames, ///< it names no coordinates
    Fits,    ///< there is one reading, and Columns are those
    Unclear  ///< it names columns, but not which is which
  };
  Kind What = NoNames;
  std::vector<Column> Columns;
  std::string Complaint; ///< why it is unclear, "found ..., expected ...", where more can be said
};

/**
 * The words of `line` that may be names of columns: without the sign of a comment, a label such as
 * "columns:", the numbers of the columns, and units.
 */
std::vector<std::string_view> NameWords(std::string_view line);

/// Whether words name enough of x, y, z and radius that they seem to be names of some of `count`
/// columns: three, or two if there are no other words or if the order of the columns may be any, or
/// one if the columns have numbers.
bool NamesSomeOfSphere(const std::vector<std::string_view>& words, std::size_t count);

/// Whether `line` lists names of `count` columns, with or without units, that are not x, y, z and
/// radius.
bool NamesOtherColumns(std::string_view line, std::size_t count);

/// Whether all words of `line` have the number of a column before them.
bool AreNumbered(std::string_view line);

/// The names without the numbers of their columns before them, "1:x", if all have one and in a way
/// that puts each in a column.
std::vector<std::string_view> WithoutNumbers(const std::vector<std::string_view>& names);

/**
 * Reads `line` as the names of `count` columns. Names may stand between blanks, commas, tabs or
 * wide gaps, may be of two words ("particle id"), have the number of their column before them
 * ("1:x") and a unit after them ("x [mm]" or "x mm"). One name may stand for all coordinates
 * ("position diameter", "(x, y, z), r"). It fits if a reading has as many names as
 * there are columns, and all readings that do agree on which are the coordinates and the radius.
 */
NamesFit FitNames(std::string_view line, std::size_t count, Radii radii);
}

#endif
