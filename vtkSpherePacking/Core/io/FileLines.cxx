// SPDX-License-Identifier: BSD-3-Clause
#include "io/FileLines.h"

#include <algorithm>
#include <cstddef>

namespace spherepacking
{
namespace
{
constexpr std::size_t BlockSize = 1 << 20;
}

//------------------------------------------------------------------------------
FileLines::FileLines(const std::string& file)
  : Ranges(file)
  , Size(FileBytes::Size(file))
  , Buffer(BlockSize + 1)
  , Next(Buffer.data())
  , End(Buffer.data())
  , Find(End)
{
}

//------------------------------------------------------------------------------
bool FileLines::IsLastBlock() const
{
  return this->BlockBegin + (this->End - this->Block()) == this->Size;
}

//------------------------------------------------------------------------------
// Reads the block that begins with the next byte.
void FileLines::Fill()
{
  this->BlockBegin = this->Position();
  const std::size_t length = std::min<unsigned long long>(BlockSize, this->Size - this->BlockBegin);
  this->Ranges.Read(this->BlockBegin, this->Buffer.data(), length);
  this->Buffer[length] = '\n';
  this->Next = this->Block();
  this->End = this->Block() + length;
  this->Find = LineFinder(this->End);
}

//------------------------------------------------------------------------------
void FileLines::SkipRestOfLine()
{
  const char* end = this->Find(this->Next);
  while (this->End - end <= 1 && !this->IsLastBlock())
  {
    this->Next = end;
    this->Fill();
    end = this->Find(this->Next);
  }
  this->Next = SkipLineEnd(end, this->End);
  this->InLine = false;
}

//------------------------------------------------------------------------------
bool FileLines::AtEnd()
{
  if (this->InLine)
  {
    this->SkipRestOfLine();
  }
  if (this->Next == this->End && !this->IsLastBlock())
  {
    this->Fill();
  }
  return this->Next == this->End;
}

//------------------------------------------------------------------------------
std::string_view FileLines::Read()
{
  if (this->AtEnd())
  {
    return {};
  }
  // With a carriage return, the byte after it must be in the block, too.
  const auto endsInBlock = [this](const char* end)
  { return this->End - end > 1 || this->IsLastBlock(); };
  const char* end = this->Find(this->Next);
  if (!endsInBlock(end) && this->Next != this->Block())
  {
    this->Fill();
    end = this->Find(this->Next);
  }
  const std::string_view line(this->Next, end - this->Next);
  this->InLine = !endsInBlock(end);
  this->WasCut = !this->InLine && end == this->End;
  this->Next = this->InLine ? end : SkipLineEnd(end, this->End);
  ++this->NextNumber;
  return line;
}

//------------------------------------------------------------------------------
vtkIdType FileLines::Skip(vtkIdType count)
{
  vtkIdType skipped = 0;
  for (; skipped < count && !this->AtEnd(); ++skipped)
  {
    this->Read();
  }
  return skipped;
}
}
