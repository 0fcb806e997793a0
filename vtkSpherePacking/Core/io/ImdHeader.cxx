// SPDX-License-Identifier: BSD-3-Clause
#include "io/ImdHeader.h"

#include "io/LineScanner.h"
#include "io/PackingFileError.h"
#include "io/Separators.h"
#include "io/TableHead.h"

#include <cstddef>

namespace spherepacking
{
namespace
{
// The fields after the sign of a comment.
std::vector<std::string_view> FieldsOf(const TextRange& comment)
{
  return Separators::Blanks().Split(comment.Begin + 1);
}

// Sets a vector from a line "#X 4.0 0.0 0.0".
void ReadVector(const TextRange& comment, double (&vector)[3])
{
  const auto fields = FieldsOf(comment);
  bool good = fields.size() == 4;
  for (std::size_t i = 0; good && i < 3; ++i)
  {
    good = ParseFinite(fields[i + 1], vector[i]);
  }
  if (!good)
  {
    throw LineError(comment.FirstLine,
      "found " + Quote(comment.Begin, comment.End) + ", expected the three numbers of a vector");
  }
}
}

//------------------------------------------------------------------------------
void ReadImdHeader(TableHead& head)
{
  if (head.Comments.empty() || View(head.Comments[0]).substr(0, 4) != "#F A")
  {
    return;
  }
  head.Ends = LineEnds::ByProgram;
  SimulationCell cell{};
  bool found[3] = {};
  for (const TextRange& comment : head.Comments)
  {
    for (std::size_t i = 0; i < 3; ++i)
    {
      constexpr std::string_view titles[] = { "#X", "#Y", "#Z" };
      if (!found[i] && FieldsOf(comment).size() > 1 && View(comment).substr(0, 2) == titles[i])
      {
        ReadVector(comment, cell.Vectors[i]);
        found[i] = true;
      }
    }
  }
  if (found[0] && found[1] && found[2])
  {
    head.Cell = cell;
  }
}
}
