// SPDX-License-Identifier: BSD-3-Clause
#ifndef TableRows_h
#define TableRows_h

#include "io/TextChunks.h"
#include "io/TextLines.h"

#include <string_view>

namespace spherepacking
{
/// Whether a field is a whole number without sign, point and exponent.
inline bool IsWhole(std::string_view field)
{
  return !field.empty() && field.find_first_not_of("0123456789") == field.npos;
}

/// Calls `look(row)` for the rows of a table, until it returns false.
template <typename Look>
void ForRows(const TextRange& text, const Look& look)
{
  LineFinder find(text.End);
  vtkIdType line = text.FirstLine;
  for (const char* p = text.Begin; p != text.End; ++line)
  {
    const char* const end = find(p);
    if (IsRow(RowKind::Data, p, end) && !look(TextRange{ SkipBlanks(p, end), end, line }))
    {
      return;
    }
    p = SkipLineEnd(end, text.End);
  }
}
}

#endif
