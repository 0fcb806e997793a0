// SPDX-License-Identifier: BSD-3-Clause
#include "bridge/SmpParallelFor.h"
#include "io/FileBytes.h"
#include "io/LineBlocks.h"
#include "io/Number.h"
#include "io/PackingFileError.h"
#include "io/Separators.h"
#include "io/TextLines.h"
#include "io/TimeSteps.h"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <string_view>

namespace spherepacking
{
namespace
{
// That of ITEM: TIMESTEP, and of ITEM: TIME, which LAMMPS writes before it with dump_modify time
// yes.
constexpr std::string_view Title = "ITEM: TIME";
constexpr std::string_view StepTitle = "ITEM: TIMESTEP";
// Small enough for a processor's cache, from which a block is searched.
constexpr std::size_t BlockSize = 1 << 18;
// By which blocks overlap, so that no title or number is cut in two.
constexpr std::size_t Overlap = 256;

/// A title that was found in a block.
struct FoundTitle
{
  unsigned long long At;
  bool IsStep;     // ITEM: TIMESTEP, or else ITEM: TIME
  bool BeforeStep; // ITEM: TIMESTEP follows the number
  std::optional<double> Time;
  bool IsCut;        // the file ends before the line of the number does
  std::string Found; // instead of the number
};

// Reads the number in the line after the title at `p`.
void ReadTime(const char* p, const char* end, bool isFileEnd, FoundTitle& title)
{
  LineFinder find(end);
  const char* const number = SkipBlanks(SkipLineEnd(find(p), end), end);
  const char* const lineEnd = find(number);
  title.IsCut = isFileEnd && lineEnd == end;
  double time = 0.0;
  const char* const after = lineEnd == end ? nullptr : ParseNumber(number, end, time);
  if (after && Separators::Blanks().EndsNumber(*after))
  {
    title.Time = time;
    const char* const next = SkipLineEnd(lineEnd, end);
    title.BeforeStep = std::string_view(next, end - next).substr(0, StepTitle.size()) == StepTitle;
  }
  else
  {
    title.Found = Quote(number, lineEnd);
  }
}

// Scans the block [begin, last) at `offset`; the text goes on to `end`, and begin[-1] is the byte
// before it.
std::vector<FoundTitle> ScanBlock(
  const char* begin, const char* last, const char* end, unsigned long long offset, bool isFileEnd)
{
  std::vector<FoundTitle> titles;
  const std::string_view text(begin, end - begin);
  for (std::size_t at = text.find(Title); at != text.npos && begin + at < last;
    at = text.find(Title, at + Title.size()))
  {
    const char* const p = begin + at;
    const bool isStep = text.substr(at, StepTitle.size()) == StepTitle;
    const char* const after = SkipBlanks(p + Title.size(), end);
    if (IsLineEnd(p[-1]) && (isStep || after == end || IsLineEnd(*after)))
    {
      FoundTitle title{ offset + at, isStep, false, std::nullopt, false, {} };
      ReadTime(p, end, isFileEnd, title);
      titles.push_back(title);
    }
  }
  return titles;
}

// In parallel, since a thread by itself takes as long to search a dump as to have it from the disk.
std::vector<std::vector<FoundTitle>> ScanFile(const std::string& file, unsigned long long size)
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
  SmpParallelFor()((static_cast<std::int64_t>(blocks.size()) + batch - 1) / batch, scan);
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
    if (!title.IsStep)
    {
      this->AddTime(title);
      return true;
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

  [[noreturn]] void Refuse(const FoundTitle& title, const std::string& expected) const
  {
    throw LineError(LineBlocks(this->File, 0, this->Size).LinesBefore(title.At) + 2,
      "found " + (title.IsCut ? "the end of the file" : title.Found) + ", expected " + expected);
  }

  const std::string& File;
  unsigned long long Size;
  std::optional<double> TimeBefore;
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
std::vector<TimeStep> FindDumpSteps(const std::string& file)
{
  const unsigned long long size = FileBytes::Size(file);
  return WithFileName(file, [&] { return JoinBlocks(ScanFile(file, size), file, size); });
}
}
