// SPDX-License-Identifier: BSD-3-Clause
#include "io/TableHead.h"

#include "io/ImdHeader.h"
#include "io/Number.h"
#include "io/PackingFileError.h"
#include "io/PackingFormats.h"
#include "io/Separators.h"
#include "io/TableLayout.h"
#include "io/TextChunks.h"

#include <limits>
#include <string_view>

namespace spherepacking
{
namespace
{
// Lines that YADE writes: "#format x_y_z_r" before exported spheres, and "##PERIODIC:: a b c", the
// edges of the cell, before packings of x y z r, in some with the number of a clump
// (V. Smilauer et al., "Yade Documentation", 2021).
void ReadYadeLine(const TextRange& comment, TableHead& head)
{
  const auto fields = Separators::Liberal().Split(comment.Begin + 1);
  if (fields.size() >= 2 && fields[0] == "format" && fields[0].data() == comment.Begin + 1)
  {
    if (fields.size() > 2)
    {
      throw LineError(comment.FirstLine,
        "found " + Quote(comment.Begin, comment.End) + ", expected #format and one word");
    }
    head.YadeNames = fields[1];
    head.Ends = LineEnds::ByProgram;
  }
  constexpr std::string_view periodic = "##PERIODIC::";
  const std::string_view line = View(comment);
  if (line.substr(0, periodic.size()) != periodic)
  {
    return;
  }
  head.YadeNames = head.YadeNames.empty() ? "x_y_z_r_attrs" : head.YadeNames;
  head.Ends = LineEnds::ByProgram;
  SimulationCell cell{};
  const auto edges = Separators::Blanks().Split(comment.Begin + periodic.size());
  for (std::size_t i = 0; i < 3; ++i)
  {
    double& edge = cell.Vectors[i][i];
    if (edges.size() != 3 ||
      ParseNumber(edges[i].data(), edges[i].data() + edges[i].size(), edge) !=
        edges[i].data() + edges[i].size() ||
      !(edge > 0 && edge <= std::numeric_limits<double>::max()))
    {
      throw LineError(comment.FirstLine,
        "found " + Quote(comment.Begin, comment.End) + ", expected the three edges of a cell");
    }
  }
  head.Cell = cell;
}

// Whatever separates them; fields with blanks in them count as several.
std::size_t CountFields(std::string_view line)
{
  std::size_t count = 0;
  bool between = true;
  for (const char c : line)
  {
    const bool separates = IsBlank(c) || c == ',' || c == ';';
    count += between && !separates;
    between = separates;
  }
  return count;
}
}

//------------------------------------------------------------------------------
TableHead FindHead(const TextRange& text)
{
  TableHead head;
  LineFinder find(text.End);
  vtkIdType number = text.FirstLine;
  for (const char* p = text.Begin; p != text.End; ++number)
  {
    const char* end = find(p);
    const char* first = SkipBlanks(p, end);
    if (IsRow(RowKind::Data, p, end))
    {
      head.Row = { first, end, number };
      CheckColumnCount(CountFields(View(head.Row)));
      ReadImdHeader(head);
      return head;
    }
    if (first != end)
    {
      AddComment({ first, end, number }, head);
    }
    p = SkipLineEnd(end, text.End);
  }
  ThrowNoSphere("lines of x y z radius");
}

//------------------------------------------------------------------------------
void AddComment(const TextRange& comment, TableHead& head)
{
  head.Comments.push_back(comment);
  ReadYadeLine(comment, head);
}

//------------------------------------------------------------------------------
TextRange FindRow(const TextRange& text)
{
  LineFinder find(text.End);
  vtkIdType number = text.FirstLine;
  for (const char* p = text.Begin; p != text.End; ++number)
  {
    const char* const end = find(p);
    if (IsRow(RowKind::Data, p, end))
    {
      return { SkipBlanks(p, end), end, number };
    }
    p = SkipLineEnd(end, text.End);
  }
  return { nullptr, nullptr, 0 };
}
}
