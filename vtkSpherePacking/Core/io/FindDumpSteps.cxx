// SPDX-License-Identifier: BSD-3-Clause
#include "bridge/SmpParallelFor.h"
#include "io/FileBytes.h"
#include "io/LineBlocks.h"
#include "io/Number.h"
#include "io/PackingFileError.h"
#include "io/TextLines.h"
#include "io/TimeSteps.h"

#include "vtkSMPTools.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <string_view>

namespace spherepacking
{
namespace
{
constexpr std::string_view Item = "ITEM:";
constexpr std::string_view StepTitle = "ITEM: TIMESTEP";
// Small enough for a processor's cache, from which a block is searched.
constexpr std::size_t BlockSize = 1 << 18;
// By which blocks overlap, so that no title or number is cut in two.
constexpr std::size_t Overlap = 256;

enum class TitleKind
{
  Step,
  Time, // which LAMMPS writes before each step with dump_modify time yes
  Units,
  Count, // ITEM: NUMBER OF ATOMS
  Atoms,
  Other // of which any may stand between ITEM: TIMESTEP and ITEM: ATOMS
};

/// A title that was found in a block.
struct FoundTitle
{
  unsigned long long At;
  TitleKind Kind;
  bool BeforeStep = false; // ITEM: TIMESTEP follows the number
  std::optional<double> Time;
  bool IsCut = false; // the file ends before the line of the number does, or of another title
};

TitleKind KindOf(std::string_view line)
{
  const auto begins = [line](std::string_view title)
  { return line.substr(0, title.size()) == title; };
  while (!line.empty() && IsBlank(line.back()))
  {
    line.remove_suffix(1);
  }
  return begins(StepTitle)                ? TitleKind::Step
    : line == "ITEM: TIME"                ? TitleKind::Time
    : begins("ITEM: UNITS")               ? TitleKind::Units
    : begins("ITEM: NUMBER OF ATOMS")     ? TitleKind::Count
    : line.substr(0, 11) == "ITEM: ATOMS" ? TitleKind::Atoms
                                          : TitleKind::Other;
}

// Reads the number in the line after the title that ends at `titleEnd`.
void ReadTime(const char* titleEnd, const char* end, bool isFileEnd, FoundTitle& title)
{
  LineFinder find(end);
  const char* const number = SkipBlanks(SkipLineEnd(titleEnd, end), end);
  const char* const lineEnd = find(number);
  title.IsCut = isFileEnd && lineEnd == end;
  double time = 0.0;
  const char* const after = lineEnd == end ? nullptr : ParseNumber(number, end, time);
  if (after && SkipBlanks(after, end) == lineEnd && std::isfinite(time))
  {
    title.Time = time;
    const char* const next = SkipLineEnd(lineEnd, end);
    title.BeforeStep = std::string_view(next, end - next).substr(0, StepTitle.size()) == StepTitle;
  }
}

// What the title at `p` says; the file goes on to `end` at least.
FoundTitle ReadTitle(const char* p, const char* end, unsigned long long at, bool isFileEnd)
{
  // So far and no further, since each title looks for the line ends after it.
  isFileEnd = isFileEnd && end - p <= static_cast<std::ptrdiff_t>(Overlap);
  end = std::min(end, p + Overlap);
  const char* const lineEnd = LineFinder(end)(p);
  FoundTitle title;
  title.At = at;
  title.Kind = KindOf({ p, static_cast<std::size_t>(lineEnd - p) });
  if (title.Kind == TitleKind::Step || title.Kind == TitleKind::Time)
  {
    ReadTime(lineEnd, end, isFileEnd, title);
  }
  else
  {
    title.IsCut = isFileEnd && lineEnd == end;
  }
  return title;
}

// Scans the block [begin, last) at `offset`; the text goes on to `end`, and begin[-1] is the byte
// before it.
std::vector<FoundTitle> ScanBlock(
  const char* begin, const char* last, const char* end, unsigned long long offset, bool isFileEnd)
{
  std::vector<FoundTitle> titles;
  const std::string_view text(begin, end - begin);
  for (std::size_t at = text.find(Item); at != text.npos && begin + at < last;
    at = text.find(Item, at + Item.size()))
  {
    if (IsLineEnd(begin[static_cast<std::ptrdiff_t>(at) - 1]))
    {
      titles.push_back(ReadTitle(begin + at, end, offset + at, isFileEnd));
    }
  }
  return titles;
}

// In parallel, since a thread by itself takes as long to search a dump as to have it from the disk.
std::vector<std::vector<FoundTitle>> ScanFile(
  const std::string& file, unsigned long long size, Progress& progress)
{
  std::vector<std::vector<FoundTitle>> blocks((size + BlockSize - 1) / BlockSize);
  constexpr std::int64_t batch = 16; // blocks for which the file is opened once
  const auto scan = [&](std::int64_t number)
  {
    FileRanges ranges(file);
    std::vector<char> buffer(1 + BlockSize + Overlap + 1);
    const std::size_t last = std::min<std::size_t>(blocks.size(), (number + 1) * batch);
    for (std::size_t i = number * batch; i < last; ++i)
    {
      const unsigned long long offset = i * BlockSize;
      const unsigned long long before = offset > 0;
      const std::size_t length = std::min<unsigned long long>(BlockSize, size - offset);
      const std::size_t all = std::min<unsigned long long>(length + Overlap, size - offset);
      char* const begin = buffer.data() + 1;
      begin[-1] = begin[all] = '\n';
      ranges.Read(offset - before, begin - before, before + all);
      blocks[i] = ScanBlock(begin, begin + length, begin + all, offset, offset + all == size);
    }
  };
  const std::int64_t count = (static_cast<std::int64_t>(blocks.size()) + batch - 1) / batch;
  const std::int64_t atATime = 2 * std::max(1, vtkSMPTools::GetEstimatedNumberOfThreads());
  for (std::int64_t first = 0; first < count; first += atATime)
  {
    const std::int64_t last = std::min(count, first + atATime);
    SmpParallelFor()(last - first, [&](std::int64_t i) { scan(first + i); });
    progress.Report(static_cast<double>(last) / static_cast<double>(count));
  }
  return blocks;
}

[[noreturn]] void ThrowNoStep(const std::string& file)
{
  const FileBytes head = FileBytes::ReadHead(file, Overlap);
  throw LineError(1,
    "found " + Quote(head.Begin(), LineFinder(head.End())(head.Begin())) +
      " and no later step, expected ITEM: TIMESTEP");
}

/// Makes steps of the titles, which come in the order of the file.
class StepCollector
{
public:
  StepCollector(const std::string& file, unsigned long long size)
    : File(file)
    , Size(size)
  {
  }

  /// Whether the titles after this one count.
  bool Add(const FoundTitle& title)
  {
    switch (title.Kind)
    {
      case TitleKind::Step:
        return this->AddStep(title);
      case TitleKind::Time:
        this->AddTime(title);
        break;
      case TitleKind::Units:
        break;
      default:
        this->AddOther(title);
    }
    return true;
  }

  std::vector<TimeStep> Take()
  {
    if (this->Steps.empty())
    {
      ThrowNoStep(this->File);
    }
    SetTimes(this->Steps, this->Numbers);
    return std::move(this->Steps);
  }

private:
  bool AddStep(const FoundTitle& title)
  {
    if (this->Stray)
    {
      this->RefuseStray(*this->Stray);
    }
    if (!this->Steps.empty())
    {
      this->Steps.back().End = title.At;
    }
    if (title.IsCut && !this->Steps.empty())
    {
      return false;
    }
    if (title.IsCut || !title.Time)
    {
      this->Refuse(title, title.IsCut ? "the time step and atoms after it" : "the time step");
    }
    this->Steps.push_back({ std::nullopt, title.At, this->Size });
    this->Numbers.push_back({ this->TimeBefore, title.Time });
    this->TimeBefore.reset();
    this->HasCount = this->HasAtoms = false;
    return true;
  }

  // Without a step after it the run was stopped there.
  void AddTime(const FoundTitle& title)
  {
    if (!title.IsCut && !title.Time)
    {
      this->Refuse(title, "the time");
    }
    if (title.BeforeStep)
    {
      this->TimeBefore = title.Time;
    }
  }

  // A title of a step whose own is not there, or after the atoms one that is none of a step, would
  // take a step with it. The last of a run that was stopped may be cut.
  void AddOther(const FoundTitle& title)
  {
    const bool again = (title.Kind == TitleKind::Count && this->HasCount) || this->HasAtoms;
    if (this->Steps.empty())
    {
      this->Stray = this->Stray ? this->Stray : title;
    }
    else if (again && !title.IsCut)
    {
      this->RefuseStray(title);
    }
    this->HasCount |= title.Kind == TitleKind::Count;
    this->HasAtoms |= title.Kind == TitleKind::Atoms;
  }

  [[noreturn]] void RefuseStray(const FoundTitle& title) const
  {
    throw LineError(LineBlocks(this->File, 0, this->Size).LinesBefore(title.At) + 1,
      "found " + this->QuoteLine(title.At) + " where a step begins, expected ITEM: TIMESTEP");
  }

  // The line at `offset` of the file, or the one after it, without blanks before it.
  std::string QuoteLine(unsigned long long offset, bool next = false) const
  {
    std::vector<char> bytes(std::min<unsigned long long>(2 * Overlap, this->Size - offset));
    FileRanges(this->File).Read(offset, bytes.data(), bytes.size());
    const char* const end = bytes.data() + bytes.size();
    LineFinder find(end);
    const char* const begin = next ? SkipLineEnd(find(bytes.data()), end) : bytes.data();
    const char* const first = SkipBlanks(begin, end);
    return Quote(first, find(first));
  }

  [[noreturn]] void Refuse(const FoundTitle& title, const std::string& expected) const
  {
    throw LineError(LineBlocks(this->File, 0, this->Size).LinesBefore(title.At) + 2,
      "found " + (title.IsCut ? "the end of the file" : this->QuoteLine(title.At, true)) +
        ", expected " + expected);
  }

  const std::string& File;
  unsigned long long Size;
  std::optional<double> TimeBefore;
  std::optional<FoundTitle> Stray; // before the first step
  bool HasCount = false;
  bool HasAtoms = false;
  std::vector<TimeStep> Steps;
  std::vector<StepNumbers> Numbers;
};

std::vector<TimeStep> JoinBlocks(const std::vector<std::vector<FoundTitle>>& blocks,
  const std::string& file, unsigned long long size)
{
  StepCollector steps(file, size);
  for (const std::vector<FoundTitle>& titles : blocks)
  {
    for (const FoundTitle& title : titles)
    {
      if (!steps.Add(title))
      {
        return steps.Take();
      }
    }
  }
  return steps.Take();
}
}

//------------------------------------------------------------------------------
std::vector<TimeStep> FindDumpSteps(const std::string& file, Progress& progress)
{
  const unsigned long long size = FileBytes::Size(file);
  return WithFileName(file, [&] { return JoinBlocks(ScanFile(file, size, progress), file, size); });
}
}
