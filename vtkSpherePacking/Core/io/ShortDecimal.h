// SPDX-License-Identifier: BSD-3-Clause
#ifndef ShortDecimal_h
#define ShortDecimal_h

#include "vtkEndian.h"

#include <cstdint>
#include <cstring>
#include <limits>

namespace spherepacking
{
/// The value of eight digits from 0 to 9, the first in the lowest byte (D. Lemire, "Number Parsing
/// at a Gigabyte per Second", 2021).
inline std::uint64_t EightDigits(std::uint64_t digits)
{
  digits = digits * 10 + (digits >> 8);
  const std::uint64_t low = (digits & 0x000000FF000000FFull) * 0x000F424000000064ull;
  const std::uint64_t high = ((digits >> 16) & 0x000000FF000000FFull) * 0x0000271000000001ull;
  return (low + high) >> 32 & 0xFFFFFFFFull;
}

/// Eight characters, the first in the lowest byte, with digits turned into their values.
inline std::uint64_t LoadDigits(const char* p)
{
  std::uint64_t text;
  std::memcpy(&text, p, 8);
  return text ^ 0x3030303030303030ull;
}

/**
 * The number `whole` + `fraction` / 10^`decimals`, with at most 7 decimals, rounded once: dividend
 * and divisor are integers that `T` holds exactly, and division rounds correctly (W. Clinger, "How
 * to Read Floating Point Numbers Accurately", 1990). False if there are too many digits for that.
 */
template <typename T>
inline bool MakeDecimal(std::uint64_t whole, std::uint64_t fraction, int decimals, T& value)
{
  constexpr std::uint32_t powers[] = { 1, 10, 100, 1000, 10000, 100000, 1000000, 10000000 };
  const std::uint64_t digits = whole * powers[decimals] + fraction;
  value = static_cast<T>(static_cast<std::int64_t>(digits)) / static_cast<T>(powers[decimals]);
  return digits <= std::uint64_t{ 1 } << std::numeric_limits<T>::digits;
}

/**
 * A fast path for numbers without sign and exponent and with 1 to 8 digits before and 1 to 7 after
 * the point, as in files of limited precision, and for integers of up to 8 digits. All decimals are
 * parsed at once in a 64-bit word.
 * Returns the end of the number, or null for anything else, a number or not.
 */
template <typename T>
inline const char* ParseShortDecimal(const char* p, const char* end, T& value)
{
#ifdef VTK_WORDS_BIGENDIAN
  return nullptr;
#else
  if (end - p < 17)
  {
    return nullptr; // LoadDigits() below would read beyond the end
  }
  const auto isDigit = [](char c) { return static_cast<unsigned char>(c - '0') < 10; };
  std::uint64_t whole = 0;
  const char* const begin = p;
  for (; p - begin < 8 && isDigit(*p); ++p)
  {
    whole = 10 * whole + static_cast<unsigned char>(*p - '0');
  }
  if (p == begin)
  {
    return nullptr;
  }
  if (*p != '.')
  {
    // An integer, as ids and types are, unless it goes on; converting it rounds once.
    value = static_cast<T>(whole);
    return isDigit(*p) || (*p | 0x20) == 'e' ? nullptr : p;
  }
  ++p;

  const std::uint64_t digits = LoadDigits(p);
  const std::uint64_t others = ((digits + 0x7676767676767676ull) | digits) & 0x8080808080808080ull;
  // Counts the bytes up to the first that is no digit, by adding up one bit of each.
  const std::uint64_t upTo = ((others & (~others + 1)) - 1) & 0x0101010101010101ull;
  const int count = static_cast<int>((upTo * 0x0101010101010101ull) >> 56) - 1;
  if (others == 0 || count == 0 || (p[count] | 0x20) == 'e')
  {
    return nullptr;
  }
  // The shift puts zeros before the digits.
  const std::uint64_t fraction = EightDigits(digits << (8 * (8 - count)));
  return MakeDecimal(whole, fraction, count, value) ? p + count : nullptr;
#endif
}
}

#endif
