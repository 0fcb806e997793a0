// SPDX-License-Identifier: BSD-3-Clause
#ifndef ColumnNames_h
#define ColumnNames_h

#include "io/TableColumn.h"

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace spherepacking
{
/// Whether a table may be without radii.
enum class Radii
{
  Required,
  Optional
};

/// More names, numbers and units than those of any table, so that a long remark takes little
/// memory.
constexpr std::size_t MostNames = 1 << 17;

/// Who calls columns by names.
enum class NamesBy
{
  File,
  User
};

/**
 * Finds the roles of columns by their names, in any letter case.
 *
 * Coordinates are x, y, z, or else the one triple of names of the form pos_x, x_pos, center x, cx,
 * Points:0 and the like, or without any px, py, pz, which may be a momentum. The radius is the
 * column radius or radii, or else r, rad or a name such as "particle radius"; without one the
 * diameter is found likewise, and beside a radius it is a further column. Where none has such a
 * name it is one such as Rp or r_eff, and then d_eq. Units may follow in brackets, or without
 * (x_mm, x/mm), if they are one and the same.
 *
 * R beside G and B is red, and r beside an angle such as theta or phi, unless the user says so, is
 * a distance; neither is a radius.
 *
 * Returns nothing if a coordinate or both radius and diameter are missing, or if there are more
 * names than MostNames. Sets `complaint`, a sentence "found ..., expected ...", if two names mean
 * one thing or the radius is none.
 */
std::optional<std::vector<Column>> ColumnsFromNames(const std::vector<std::string_view>& names,
  std::string& complaint, Radii radii = Radii::Required, NamesBy by = NamesBy::File);

}

#endif
