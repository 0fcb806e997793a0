// SPDX-License-Identifier: BSD-3-Clause
#ifndef TableHead_h
#define TableHead_h

#include "bridge/PackingArrays.h"
#include "io/FitNames.h"
#include "io/TextLines.h"

#include <optional>
#include <string_view>
#include <vector>

namespace spherepacking
{
/// The lines at the beginning of a table: comments, and the first that is none.
struct TableHead
{
  std::vector<TextRange> Comments;    ///< without blank ones
  std::string_view YadeNames;         ///< the field after #format of YADE, or empty
  std::optional<SimulationCell> Cell; ///< after ##PERIODIC:: of YADE
  TextRange Row{ nullptr, nullptr, 0 };
};

/// Throws if `text` has no line but comments.
TableHead FindHead(const TextRange& text);

/// The first line that is no comment, or one that begins nowhere.
TextRange FindRow(const TextRange& text);

inline std::string_view View(const TextRange& line)
{
  return std::string_view(line.Begin, line.End - line.Begin);
}

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
