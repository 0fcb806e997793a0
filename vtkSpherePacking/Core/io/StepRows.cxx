// SPDX-License-Identifier: BSD-3-Clause
#include "io/StepRows.h"

#include "io/TextTable.h"

#include <algorithm>
#include <optional>

namespace spherepacking
{
namespace
{
// Parses the rows from `offset` of the file on, and returns how many there are. The parser may have
// room for fewer, if their number is a lie or a row too short.
vtkIdType ParseBlocks(LineBlocks& blocks, const StepRows& rows, unsigned long long offset,
  TableParser& parser, const ReadOptions& options, Progress& progress)
{
  const auto total = static_cast<double>(blocks.BytesFrom(offset));
  Progress silent(nullptr);
  vtkIdType count = 0;
  blocks.GoTo(offset);
  for (bool ended = false; !ended && blocks.Next();)
  {
    TextRange text = blocks.Text();
    const char* const end = rows.End(text);
    ended = end != text.End;
    text.End = end;
    blocks.AddLines(
      [&]
      {
        if (blocks.IsLast() && !ended)
        {
          CheckNotCut(text, rows.Ends, parser.Layout().Between);
        }
        const auto chunks = CutIntoChunks(text, RowKind::Data, options.ChunkSize, count, silent);
        count = std::max(count, CountRows(chunks));
        if (count <= parser.Count())
        {
          parser.Parse(blocks.Text().End, chunks, silent);
        }
        else if (count <= rows.Count)
        {
          // There is one, here or later: more rows than have room in the file have too few fields.
          CheckNoShortRow(text, parser.Layout());
        }
      });
    progress.Report(1.0 - static_cast<double>(blocks.BytesFrom(blocks.OffsetOf(end))) / total);
  }
  return count;
}
}

//------------------------------------------------------------------------------
PackingArrays ReadStepRows(LineBlocks& blocks, const StepRows& rows, const TableLayout& layout,
  const ReadOptions& options, Progress& progress)
{
  const unsigned long long offset = blocks.OffsetOf(rows.Begin);
  const unsigned long long head = blocks.OffsetOf(blocks.Text().Begin);
  // The count is believed only as far as the file is long: a field takes two bytes with the blank
  // or line end after it, which may be missing in the end.
  const auto most =
    static_cast<vtkIdType>((blocks.BytesFrom(offset) + 1) / (2 * layout.Columns.size()));
  std::optional<TableLayout> roles = layout;
  while (true)
  {
    TableParser parser(*roles, std::min(rows.Count, most), options.Single);
    const vtkIdType count = ParseBlocks(blocks, rows, offset, parser, options, progress);
    if (count != rows.Count)
    {
      CheckCount(rows.Count, rows.Things, rows.CountLine + blocks.LinesBefore(head), count);
    }
    roles = parser.LayoutWithText();
    if (!roles)
    {
      return parser.Take();
    }
  }
}
}
