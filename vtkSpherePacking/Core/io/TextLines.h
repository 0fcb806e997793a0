// SPDX-License-Identifier: BSD-3-Clause
#ifndef TextLines_h
#define TextLines_h

#include "vtkType.h"

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
 * Finds line ends in ascending order. It remembers the next LF, so that a text that ends its lines
 * in CR is still scanned in linear time, and looks for a CR before that alone.
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
      this->NextLf = Find(p, this->End, '\n');
    }
    return Find(p, this->NextLf, '\r');
  }

private:
  static const char* Find(const char* p, const char* end, char c)
  {
    const void* found = p < end ? std::memchr(p, c, end - p) : nullptr;
    return found ? static_cast<const char*>(found) : end;
  }

  const char* End;
  const char* NextLf = nullptr;
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
