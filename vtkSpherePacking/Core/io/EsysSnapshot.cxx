// SPDX-License-Identifier: BSD-3-Clause
#include "io/EsysSnapshot.h"

#include "io/LineCursor.h"
#include "io/TableLayout.h"
#include "io/XyzComment.h"

#include "vtksys/SystemTools.hxx"

#include <algorithm>
#include <string_view>

namespace spherepacking
{
namespace
{
constexpr const char* FirstLine = "V 3, the version of a snapshot of ESyS-Particle";

// Whether a text begins with a count and a particle, which may rotate or not.
bool BeginsAsParticles(const TextRange& text)
{
  LineCursor lines(text);
  if (!lines.Step() || !XyzCount(lines.Line()) || !lines.Step())
  {
    return false;
  }
  const auto fields = lines.Fields();
  return (fields.size() == 22 || fields.size() == 29) &&
    std::all_of(fields.begin(), fields.end(), [](auto field) { return IsNumber(field); });
}

double NextNumber(LineCursor& lines, const std::string& expected)
{
  lines.StepInto("the file", expected);
  const std::vector<double> numbers = lines.Numbers(expected);
  if (numbers.size() != 1)
  {
    lines.Refuse(expected);
  }
  return numbers[0];
}

// The `count` numbers after `word` in the next line.
std::vector<double> NumbersAfter(LineCursor& lines, const std::string& word, std::size_t count)
{
  const std::string expected = word + " and " + std::to_string(count) + " numbers";
  lines.StepInto("the file", expected);
  const auto fields = lines.Fields();
  std::vector<double> numbers;
  for (std::size_t i = 1; i < fields.size() && fields[0] == word; ++i)
  {
    double value;
    const char* const end = fields[i].data() + fields[i].size();
    if (ParseNumber(fields[i].data(), end, value) == end && std::isfinite(value))
    {
      numbers.push_back(value);
    }
  }
  if (numbers.size() != count || fields.size() != count + 1)
  {
    lines.Refuse(expected);
  }
  return numbers;
}

SimulationCell NextCell(LineCursor& lines)
{
  const std::vector<double> corners = NumbersAfter(lines, "BoundingBox", 6);
  const std::vector<double> periodic = NumbersAfter(lines, "PeriodicBoundaries", 3);
  if (std::any_of(periodic.begin(), periodic.end(), [](double p) { return p != 0 && p != 1; }))
  {
    lines.Refuse("PeriodicBoundaries and 3 numbers, 0 or 1");
  }
  SimulationCell cell{};
  for (int axis = 0; axis < 3; ++axis)
  {
    cell.Origin[axis] = corners[axis];
    cell.Vectors[axis][axis] = corners[axis + 3] - corners[axis];
    cell.Periodic[axis] = periodic[axis] != 0;
  }
  return cell;
}
}

//------------------------------------------------------------------------------
bool BeginsAsEsysSnapshot(const char* begin, const char* end)
{
  if (BeginsAsParticles({ begin, end }))
  {
    return true;
  }
  LineCursor lines({ begin, end });
  if (!lines.Step() || lines.Fields().size() != 2 || lines.Fields()[0] != "V")
  {
    return false;
  }
  for (int line = 2; line < 6; ++line)
  {
    if (!lines.Step())
    {
      return false;
    }
  }
  return lines.Step() && !lines.Fields().empty() && lines.Fields()[0] == "BoundingBox";
}

//------------------------------------------------------------------------------
EsysSnapshot ParseEsysSnapshot(const TextRange& text)
{
  LineCursor lines(text);
  lines.StepInto("the file", FirstLine);
  if (BeginsAsParticles(text))
  {
    throw LineError(1,
      "found the particles of one worker of ESyS-Particle, expected the first file of the "
      "snapshot, NAME_0.txt, which names those of all workers");
  }
  const auto version = lines.Fields();
  if (version.size() != 2 || version[0] != "V" || version[1] != "3")
  {
    lines.Refuse(FirstLine);
  }
  EsysSnapshot snapshot{};
  NextNumber(lines, "the number of time steps");
  const double length = NextNumber(lines, "the length of a time step");
  snapshot.Time = length * NextNumber(lines, "the number of the time step");
  lines.StepInto("the file", "the program that wrote it");
  snapshot.Cell = NextCell(lines);
  lines.StepInto("the file", "Dimension");
  lines.StepInto("the file", "the names of the files of particles");
  snapshot.FilesLine = lines.Number();
  for (const std::string_view file : lines.Fields())
  {
    snapshot.Files.push_back(vtksys::SystemTools::GetFilenameName(std::string(file)));
  }
  if (snapshot.Files.empty())
  {
    lines.Refuse("the names of the files of particles");
  }
  return snapshot;
}
}
