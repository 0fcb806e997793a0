// SPDX-License-Identifier: BSD-3-Clause
#include "io/FileLines.h"
#include "io/MercuryHeader.h"
#include "io/Number.h"
#include "io/PackingFileError.h"
#include "io/Separators.h"
#include "io/TimeSteps.h"
#include "io/XyzComment.h"

#include <algorithm>
#include <cstddef>
#include <optional>

namespace spherepacking
{
namespace
{
bool IsBlankLine(std::string_view line)
{
  return line.find_first_not_of(" \t") == line.npos;
}

/// What the lines before the rows of a step say.
struct StepHead
{
  bool IsWhole; ///< false if the file ends within them
  vtkIdType Count;
  StepNumbers Times;
};

// Skips the rows of a step, and reports how far in the file that is.
void SkipRows(FileLines& lines, vtkIdType count, unsigned long long size, Progress& progress)
{
  constexpr vtkIdType atATime = 1 << 16;
  for (vtkIdType left = count; left > 0 && !lines.AtEnd(); left -= atATime)
  {
    lines.Skip(std::min(left, atATime));
    progress.Report(static_cast<double>(lines.Position()) / static_cast<double>(size));
  }
}

// Finds the steps of a file in which each begins with its number of rows. `readHead` reads the
// lines before the rows.
template <typename ReadHead>
std::vector<TimeStep> FindCountedSteps(
  const std::string& file, Progress& progress, const ReadHead& readHead)
{
  FileLines lines(file);
  const unsigned long long size = FileBytes::Size(file);
  std::vector<TimeStep> steps;
  std::vector<StepNumbers> times;
  std::optional<vtkIdType> previous; // first line of the step before
  while (!lines.AtEnd())
  {
    TimeStep step{ std::nullopt, lines.Position(), size };
    const vtkIdType line = lines.Number();
    const StepHead head = readHead(lines, previous);
    if (!head.IsWhole)
    {
      break;
    }
    SkipRows(lines, head.Count, size, progress);
    if (!lines.AtEnd())
    {
      step.End = lines.Position();
    }
    steps.push_back(step);
    times.push_back(head.Times);
    previous = line;
  }
  SetTimes(steps, times);
  return steps;
}

// An addition to an error after the first step: a wrong count before it is as likely.
std::string AfterRows(const std::optional<vtkIdType>& previous)
{
  return !previous ? "" : " after as many rows as line " + std::to_string(*previous) + " says";
}

// The first line of a step, which blank lines may precede; blank at the end of the file.
std::string FirstLine(FileLines& lines)
{
  std::string line(lines.Read());
  while (IsBlankLine(line) && !lines.AtEnd())
  {
    line = lines.Read();
  }
  return line;
}

StepHead ReadXyzHead(FileLines& lines, const std::optional<vtkIdType>& previous)
{
  const std::string first = FirstLine(lines);
  const vtkIdType number = lines.Number() - 1;
  // The run was stopped here.
  if (lines.AtEnd() && previous && (IsBlankLine(first) || XyzCount(first)))
  {
    return { false, 0, {} };
  }
  const std::optional<vtkIdType> count = XyzCount(first);
  if (!count)
  {
    throw LineError(number,
      "found " + Quote(first.data(), first.data() + first.size()) +
        ", expected the number of atoms" + AfterRows(previous));
  }
  if (lines.AtEnd())
  {
    throw LineError(
      number, "found the end of the file after the number of atoms, expected a comment and atoms");
  }
  const StepNumbers times = XyzComment(lines.Read()).Times();
  const bool isCut = *count > 0 && lines.AtEnd() && lines.EndedWithFile();
  return { !previous || !isCut, *count, times };
}

StepHead ReadMercuryHead(FileLines& lines, const std::optional<vtkIdType>& previous)
{
  const std::string first = FirstLine(lines);
  // The run was stopped here.
  if (lines.AtEnd() && previous && (IsBlankLine(first) || lines.EndedWithFile()))
  {
    return { false, 0, {} };
  }
  const auto header = ParseMercuryHeader(first);
  if (!header)
  {
    throw LineError(lines.Number() - 1,
      "found " + Quote(first.data(), first.data() + first.size()) + ", expected " +
        MercuryHeader::Expected + AfterRows(previous));
  }
  return { true, header->Count, { header->Time } };
}
}

//------------------------------------------------------------------------------
std::vector<TimeStep> FindXyzSteps(const std::string& file, Progress& progress)
{
  return WithFileName(file, [&] { return FindCountedSteps(file, progress, ReadXyzHead); });
}

//------------------------------------------------------------------------------
std::vector<TimeStep> FindMercurySteps(const std::string& file, Progress& progress)
{
  return WithFileName(file, [&] { return FindCountedSteps(file, progress, ReadMercuryHead); });
}
}
