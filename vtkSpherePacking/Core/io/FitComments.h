// SPDX-License-Identifier: BSD-3-Clause
#ifndef FitComments_h
#define FitComments_h

#include "io/FitNames.h"
#include "io/TableHead.h"

#include <cstddef>

namespace spherepacking
{
/// What comments say about rows of some columns, and where.
struct CommentFit : NamesFit
{
  TextRange Line{ nullptr, nullptr, 0 };
  bool OneEach = false; ///< a comment for each column
};

/**
 * Looks for the names of `count` columns in comments: the last one that names all, or else one
 * comment for each column, in turn or with its number; or else one that names columns, but not all.
 */
CommentFit FitComments(const TableHead& head, std::size_t count, Radii radii);
}

#endif
