// SPDX-License-Identifier: BSD-3-Clause
#ifndef ShortDecimal_h
#define ShortDecimal_h

#include "vtkEndian.h"

#include <cstdint>
#include <cstring>
#include <limits>

namespace spherepacking
{
/// The value of eight digits, the first in the lowest byte (D. Lemire, "Number Parsing at a
/// Gigabyte per Second", 2021).
inline std::uint64_t EightDigits(std::uint64_t text)
{
  text -= 0x3030303030303030ull;
  text = text * 10 + (text >> 8);
  const std::uint64_t low = (text & 0x000000FF000000FFull) * 0x000F424000000064ull;
  const std::uint64_t high = ((text >> 16) & 0x000000FF000000FFull) * 0x0000271000000001ull;
  return (low + high) >> 32 & 0xFFFFFFFFull;
}

/**
 * Reads a number without sign and exponent that has at most 8 digits before and 1 to 7 after its
 * point, as most files of limited precision have, without a branch for each digit. The digits as
 * an integer and the power of ten are exact, so their quotient is rounded once (W. Clinger, "How
 * to Read Floating Point Numbers Accurately", 1990). Null for anything else, be it a number or
 * not.
 */
template <typename T>
inline const char* ParseShortDecimal(const char* p, const char* end, T& value)
{
#ifdef VTK_WORDS_BIGENDIAN
  return nullptr;
#else
  if (end - p < 17)
  {
    return nullptr; // what is read below at once may not be there
  }
  const auto isDigit = [](char c) { return static_cast<unsigned char>(c - '0') < 10; };
  std::uint64_t digits = 0;
  const char* const begin = p;
  for (; p - begin < 8 && isDigit(*p); ++p)
  {
    digits = 10 * digits + static_cast<unsigned char>(*p - '0');
  }
  if (p == begin || *p != '.')
  {
    return nullptr;
  }
  ++p;

  std::uint64_t text;
  std::memcpy(&text, p, 8);
  const std::uint64_t nibbles = text ^ 0x3030303030303030ull; // 0 to 9 where there is a digit
  const std::uint64_t others =
    ((nibbles + 0x7676767676767676ull) | nibbles) & 0x8080808080808080ull;
  // The bytes up to the first that is no digit, counted by adding up a bit of each.
  const std::uint64_t upTo = ((others & (~others + 1)) - 1) & 0x0101010101010101ull;
  const int count = static_cast<int>((upTo * 0x0101010101010101ull) >> 56) - 1;
  if (others == 0 || count == 0 || (p[count] | 0x20) == 'e')
  {
    return nullptr;
  }
  // As if zeros stood before the digits.
  text = (text << (8 * (8 - count))) | (0x3030303030303030ull >> (8 * count));
  constexpr std::uint32_t powers[] = { 1, 10, 100, 1000, 10000, 100000, 1000000, 10000000 };
  digits = digits * powers[count] + EightDigits(text);
  if (digits > std::uint64_t{ 1 } << std::numeric_limits<T>::digits)
  {
    return nullptr;
  }
  value = static_cast<T>(static_cast<std::int64_t>(digits)) / static_cast<T>(powers[count]);
  return p + count;
#endif
}
}

#endif
