// SPDX-License-Identifier: BSD-3-Clause
#include "io/DumpFile.h"

#include "io/FileBytes.h"
#include "io/Number.h"
#include "io/PackingFileError.h"
#include "io/Progress.h"
#include "io/Separators.h"

#include <algorithm>
#include <string_view>

namespace spherepacking
{
namespace
{
constexpr std::string_view Title = "ITEM: TIMESTEP";
constexpr unsigned long long Overlap = 256; // of blocks

// The next title that begins in [p, last); the text goes on to `end`.
const char* FindTitle(const char* p, const char* last, const char* end)
{
  const std::size_t at = std::string_view(p, end - p).find(Title);
  return at != std::string_view::npos && p + at < last ? p + at : nullptr;
}

// The number in the line after the title at `p`.
double ReadTime(const char* p, const char* end, vtkIdType line)
{
  LineFinder find(end);
  const char* number = SkipBlanks(SkipLineEnd(find(p), end), end);
  double time = 0.0;
  const char* after = ParseNumber(number, end, time);
  if (!after || !Separators::Liberal().EndsNumber(*after))
  {
    throw LineError(line + 1, "found " + Quote(number, find(number)) + ", expected the time step");
  }
  return time;
}

// Finds the steps in blocks, which overlap by what a title and its number may take, so that none is
// cut in two.
std::vector<DumpStep> ScanBlocks(const std::string& file, unsigned long long size)
{
  constexpr unsigned long long block = 16 << 20;
  Progress silent(nullptr);
  std::vector<DumpStep> steps;
  vtkIdType line = 1;
  char previous = '\n';
  for (unsigned long long offset = 0; offset < size; offset += block)
  {
    const unsigned long long length = std::min(block, size - offset);
    const FileBytes bytes =
      FileBytes::ReadRange(file, offset, std::min(length + Overlap, size - offset), silent);
    const char* const begin = bytes.Begin();
    const char* const last = begin + length;
    // A CR LF across the cut was counted with its CR.
    const char* counted = previous == '\r' && *begin == '\n' ? begin + 1 : begin;
    for (const char* p = begin; (p = FindTitle(p, last, bytes.End())); p += Title.size())
    {
      if (IsLineEnd(p == begin ? previous : p[-1]))
      {
        line += CountLineEnds(counted, p);
        counted = p;
        const unsigned long long at = offset + (p - begin);
        if (!steps.empty())
        {
          steps.back().End = at;
        }
        steps.push_back({ ReadTime(p, bytes.End(), line), at, size, line });
      }
    }
    line += CountLineEnds(counted, last);
    previous = last[-1];
  }
  return steps;
}

[[noreturn]] void ThrowNoStep(const FileBytes& head)
{
  throw LineError(1,
    "found " + Quote(head.Begin(), LineFinder(head.End())(head.Begin())) +
      " and no later step, expected ITEM: TIMESTEP");
}
}

//------------------------------------------------------------------------------
std::vector<DumpStep> FindDumpSteps(const std::string& file)
{
  const unsigned long long size = FileBytes::Size(file);
  const auto find = [&]
  {
    std::vector<DumpStep> steps = ScanBlocks(file, size);
    if (steps.empty())
    {
      ThrowNoStep(FileBytes::ReadHead(file, Overlap));
    }
    return steps;
  };
  return WithFileName(file, find);
}
}
