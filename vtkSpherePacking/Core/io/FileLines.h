// SPDX-License-Identifier: BSD-3-Clause
#ifndef FileLines_h
#define FileLines_h

#include "io/FileBytes.h"
#include "io/TextLines.h"

#include <string>
#include <string_view>
#include <vector>

namespace spherepacking
{
/// Goes through the lines of a file in order, with a block of it in memory at a time.
class FileLines
{
public:
  explicit FileLines(const std::string& file);

  /// Whether there is no further line.
  bool AtEnd();

  /// Where the next line begins, if AtEnd() was asked before, and its number.
  unsigned long long Position() const { return this->BlockBegin + (this->Next - this->Block()); }
  vtkIdType Number() const { return this->NextNumber; }

  /// The next line without its end, clipped to a block if it is longer, and moves on. It is good
  /// until the next call, and a line end, perhaps of another line, follows it.
  std::string_view Read();

  /// Whether the line that was read last ended with the file rather than with a line end.
  bool EndedWithFile() const { return this->WasCut; }

  /// Moves on by `count` lines; returns how many there were.
  vtkIdType Skip(vtkIdType count);

private:
  const char* Block() const { return this->Buffer.data(); }
  bool IsLastBlock() const;
  void Fill();
  void SkipRestOfLine();

  FileRanges Ranges;
  unsigned long long Size;
  unsigned long long BlockBegin = 0;
  std::vector<char> Buffer;
  const char* Next;
  const char* End;
  LineFinder Find;
  bool InLine = false; // of which a part was read
  bool WasCut = false;
  vtkIdType NextNumber = 1;
};
}

#endif
