// SPDX-License-Identifier: BSD-3-Clause
#ifndef Utf8Mark_h
#define Utf8Mark_h

#include <cstring>

namespace spherepacking
{
/// Skips the byte order mark that some editors put before UTF-8.
inline const char* SkipUtf8Mark(const char* begin, const char* end)
{
  return end - begin >= 3 && std::memcmp(begin, "\xEF\xBB\xBF", 3) == 0 ? begin + 3 : begin;
}
}

#endif
