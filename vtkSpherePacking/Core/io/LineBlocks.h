// SPDX-License-Identifier: BSD-3-Clause
#ifndef LineBlocks_h
#define LineBlocks_h

#include "io/FileBytes.h"
#include "io/PackingFileError.h"
#include "io/TextLines.h"

#include <cstddef>
#include <memory>
#include <string>

namespace spherepacking
{
/**
 * A range of a file in blocks of whole lines, one of which is in memory at a time, so that a step
 * of a file takes no more memory than its arrays.
 */
class LineBlocks
{
public:
  LineBlocks(const std::string& file, unsigned long long begin, unsigned long long end);

  /// Moves on to the next block, the first at first; false if there is none.
  bool Next();

  /// Doubles the current block; false if it is the last.
  bool Grow();

  /// The next block will begin at `offset` of the file.
  void GoTo(unsigned long long offset) { this->NextOffset = offset; }

  /// The current block. The number of its first line is 1, see AddLines().
  TextRange Text() const { return { this->Buffer.get(), this->Buffer.get() + this->Length }; }
  bool IsLast() const { return this->NextOffset == this->RangeEnd; }
  unsigned long long OffsetOf(const char* p) const
  {
    return this->Offset + (p - this->Buffer.get());
  }

  /// How many bytes the range has from `offset` on.
  unsigned long long BytesFrom(unsigned long long offset) const { return this->RangeEnd - offset; }

  /// How many lines of the file end before `offset`. Takes as long as it takes to read them, so it
  /// is for errors.
  vtkIdType LinesBefore(unsigned long long offset) const;

  /// Returns work(), and adds the lines before the current block to a LineError that leaves it.
  template <typename Work>
  auto AddLines(const Work& work) const
  {
    try
    {
      return work();
    }
    catch (const LineError& error)
    {
      throw LineError(error.Line + this->LinesBefore(this->Offset), error.what());
    }
  }

private:
  void Load();

  std::string File;
  unsigned long long RangeEnd;
  unsigned long long Offset = 0; // of the block
  unsigned long long NextOffset;
  std::size_t Capacity;
  std::unique_ptr<char[]> Buffer;
  std::size_t Length = 0;
};
}

#endif
