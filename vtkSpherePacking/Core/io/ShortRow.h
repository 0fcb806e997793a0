// SPDX-License-Identifier: BSD-3-Clause
#ifndef ShortRow_h
#define ShortRow_h

#include "io/ShortDecimal.h"
#include "io/TextLines.h"

#include <cstdint>

#ifdef __SSE2__
#include <emmintrin.h>
#endif

namespace spherepacking
{
#ifdef __SSE2__
/**
 * Bit masks of the bytes of a kind among 64, the first in the lowest bit (G. Langdale and D.
 * Lemire, "Parsing Gigabytes of JSON per Second", 2019). SSE2 is part of x86-64.
 */
struct ByteMasks
{
  explicit ByteMasks(const char* p)
  {
    for (int i = 0; i < 64; i += 16)
    {
      const __m128i text = _mm_loadu_si128(reinterpret_cast<const __m128i*>(p + i));
      // '0' to '9' become the ten largest signed bytes.
      const __m128i digits = _mm_add_epi8(text, _mm_set1_epi8(127 - '9'));
      this->Others |= Bits(_mm_cmplt_epi8(digits, _mm_set1_epi8(127 - 9))) << i;
      this->Spaces |= Bits(_mm_cmpeq_epi8(text, _mm_set1_epi8(' '))) << i;
      this->Minuses |= Bits(_mm_cmpeq_epi8(text, _mm_set1_epi8('-'))) << i;
    }
  }

  static std::uint64_t Bits(__m128i bytes)
  {
    return static_cast<std::uint64_t>(_mm_movemask_epi8(bytes));
  }

  std::uint64_t Others = 0; ///< all but digits
  std::uint64_t Spaces = 0;
  std::uint64_t Minuses = 0;
};
#endif

/**
 * A fast path for rows of four numbers as ParseShortDecimal() takes, each with or without a minus,
 * separated by a space each, within 64 bytes. The ends of all fields are found at once, so the
 * processor parses the four side by side, whereas one after the other each would wait for the end
 * of the last. Returns the line end, or null for anything else, a row or not.
 */
template <typename T>
inline const char* ParseShortRow(const char* p, const char* end, T (&values)[4])
{
#ifdef __SSE2__
  if (end - p < 64 + 8)
  {
    return nullptr; // the loads below would read beyond the end
  }
  const ByteMasks masks(p);
  const std::uint64_t signs = masks.Minuses & (masks.Spaces << 1 | 1);
  std::uint64_t marks = masks.Others & ~signs; // point, space, ..., point, line end
  const auto nextMark = [&marks]
  {
    const int position = __builtin_ctzll(marks);
    marks &= marks - 1;
    return position;
  };
  int begin = 0;
  for (T& value : values)
  {
    if ((marks & (marks - 1)) == 0)
    {
      return nullptr; // fewer than two marks
    }
    const int point = nextMark();
    const int last = nextMark();
    const int negative = static_cast<int>(signs >> begin & 1);
    begin += negative;
    const int wholes = point - begin;
    const int decimals = last - point - 1;
    if (p[point] != '.' || wholes < 1 || wholes > 8 || decimals < 1 || decimals > 7)
    {
      return nullptr;
    }
    // The shifts put zeros before the digits.
    const std::uint64_t whole = EightDigits(LoadDigits(p + begin) << (8 * (8 - wholes)));
    const std::uint64_t fraction = EightDigits(LoadDigits(p + point + 1) << (8 * (8 - decimals)));
    if (!MakeDecimal(whole, fraction, decimals, value))
    {
      return nullptr;
    }
    constexpr T factors[] = { 1, -1 };
    value *= factors[negative];
    const bool isLast = &value == values + 3;
    if (isLast ? !IsLineEnd(p[last]) : p[last] != ' ')
    {
      return nullptr;
    }
    begin = last + !isLast;
  }
  return p + begin;
#else
  return nullptr;
#endif
}
}

#endif
