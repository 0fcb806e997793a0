// SPDX-License-Identifier: BSD-3-Clause
#include "io/LineBlocks.h"

#include "bridge/SmpParallelFor.h"

#include <algorithm>
#include <cstdint>
#include <vector>

namespace spherepacking
{
namespace
{
constexpr std::size_t FirstCapacity = 16 << 20;
constexpr std::size_t PieceSize = 1 << 20; // that a thread reads at a time
}

//------------------------------------------------------------------------------
LineBlocks::LineBlocks(const std::string& file, unsigned long long begin, unsigned long long end)
  : File(file)
  , RangeEnd(end)
  , NextOffset(begin)
  , Capacity(std::min<unsigned long long>(FirstCapacity, end - begin))
  , Buffer(new char[Capacity + 1])
{
}

//------------------------------------------------------------------------------
bool LineBlocks::Next()
{
  if (this->IsLast())
  {
    return false;
  }
  this->Offset = this->NextOffset;
  this->Load();
  return true;
}

//------------------------------------------------------------------------------
bool LineBlocks::Grow()
{
  if (this->IsLast())
  {
    return false;
  }
  this->Capacity = std::min<unsigned long long>(2 * this->Capacity, this->RangeEnd - this->Offset);
  this->Buffer.reset(new char[this->Capacity + 1]);
  this->Load();
  return true;
}

//------------------------------------------------------------------------------
// Reads the block at Offset, which ends at the last line end that is in it. The byte after its end
// is a line end, too.
void LineBlocks::Load()
{
  const unsigned long long left = this->RangeEnd - this->Offset;
  const std::size_t read = std::min<unsigned long long>(this->Capacity, left);
  char* const begin = this->Buffer.get();
  // In parallel since the time goes into copying, from what the system has cached.
  SmpParallelFor()(static_cast<std::int64_t>((read + PieceSize - 1) / PieceSize),
    [&](std::int64_t piece)
    {
      const std::size_t at = piece * PieceSize;
      FileRanges(this->File).Read(this->Offset + at, begin + at, std::min(PieceSize, read - at));
    });
  std::size_t length = read;
  if (read < left)
  {
    // A line feed may follow after a last carriage return.
    length -= begin[length - 1] == '\r';
    while (length > 0 && !IsLineEnd(begin[length - 1]))
    {
      --length;
    }
  }
  this->NextOffset = this->Offset + length;
  this->Length = length;
  begin[length] = '\n';
  if (length == 0)
  {
    this->Grow(); // a line is longer
  }
}

//------------------------------------------------------------------------------
vtkIdType LineBlocks::LinesBefore(unsigned long long offset) const
{
  FileRanges ranges(this->File);
  std::vector<char> bytes(1 << 20);
  vtkIdType lines = 0;
  char previous = 0;
  for (unsigned long long at = 0; at < offset; at += bytes.size())
  {
    const std::size_t length = std::min<unsigned long long>(bytes.size(), offset - at);
    ranges.Read(at, bytes.data(), length);
    for (std::size_t i = 0; i < length; ++i)
    {
      lines += bytes[i] == '\r' || (bytes[i] == '\n' && previous != '\r');
      previous = bytes[i];
    }
  }
  return lines;
}
}
