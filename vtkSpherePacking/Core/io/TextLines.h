// SPDX-License-Identifier: BSD-3-Clause
#ifndef TextLines_h
#define TextLines_h

#include "vtkType.h"

#include <algorithm>
#include <cstring>

namespace spherepacking
{
/**
 * A range of a text file, with the number of its first line in the file. `*End` must be readable.
 */
struct TextRange
{
  const char* Begin;
  const char* End;
  vtkIdType FirstLine = 1;
};

inline bool IsLineEnd(char c)
{
  return c == '\n' || c == '\r';
}

inline bool IsBlank(char c)
{
  return c == ' ' || c == '\t';
}

inline const char* SkipBlanks(const char* p, const char* end)
{
  while (p != end && IsBlank(*p))
  {
    ++p;
  }
  return p;
}

/// The beginning of the line after the terminator at `p`: LF, CR LF or a lone CR.
inline const char* SkipLineEnd(const char* p, const char* end)
{
  if (p == end)
  {
    return p;
  }
  return p + ((*p == '\r' && p + 1 != end && p[1] == '\n') ? 2 : 1);
}

/**
 * Finds line ends in ascending order. It remembers the next LF and the next CR, so that a text with
 * only one of the two is still scanned in linear time.
 */
class LineFinder
{
public:
  explicit LineFinder(const char* end)
    : End(end)
  {
  }

  /// The terminator of the line that `p` is in, or the end. `p` must not be before that of the last
  /// call.
  const char* operator()(const char* p)
  {
    if (!this->NextLf || this->NextLf < p)
    {
      this->NextLf = this->Find(p, '\n');
    }
    if (!this->NextCr || this->NextCr < p)
    {
      this->NextCr = this->Find(p, '\r');
    }
    return std::min(this->NextLf, this->NextCr);
  }

private:
  const char* Find(const char* p, char c) const
  {
    const void* found = p < this->End ? std::memchr(p, c, this->End - p) : nullptr;
    return found ? static_cast<const char*>(found) : this->End;
  }

  const char* End;
  const char* NextLf = nullptr;
  const char* NextCr = nullptr;
};

/// How many line terminators [begin, end) holds.
inline vtkIdType CountLineEnds(const char* begin, const char* end)
{
  LineFinder find(end);
  vtkIdType count = 0;
  for (const char* p = find(begin); p != end; p = find(p))
  {
    p = SkipLineEnd(p, end);
    ++count;
  }
  return count;
}
}

#endif
