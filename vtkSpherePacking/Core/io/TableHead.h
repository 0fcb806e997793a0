// SPDX-License-Identifier: BSD-3-Clause
#ifndef TableHead_h
#define TableHead_h

#include "bridge/PackingArrays.h"
#include "io/CutFile.h"
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
  std::optional<SimulationCell> Cell; ///< after ##PERIODIC:: of YADE, or of IMD
  LineEnds Ends = LineEnds::ByPeople;
  TextRange Row{ nullptr, nullptr, 0 };
};

/// Throws if `text` has no line but comments.
TableHead FindHead(const TextRange& text);

/// Appends a comment that is not blank, and what it says in the language of YADE.
void AddComment(const TextRange& comment, TableHead& head);

/// The first line that is no comment, or one that begins nowhere.
TextRange FindRow(const TextRange& text);

inline std::string_view View(const TextRange& line)
{
  return std::string_view(line.Begin, line.End - line.Begin);
}
}

#endif
