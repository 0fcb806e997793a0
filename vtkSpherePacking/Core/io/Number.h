// SPDX-License-Identifier: BSD-3-Clause
#ifndef Number_h
#define Number_h

#include "io/ShortDecimal.h"

#include "vtkfast_float.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <iterator>
#include <limits>
#include <string>
#include <string_view>
#include <system_error>

namespace spherepacking
{
/**
 * Reads one number as strtod does in the C locale, whatever the locale is: rounded to the nearest
 * `T`, ties to even, directly from the digits (D. Lemire, "Number Parsing at a Gigabyte per
 * Second", 2021). Beyond the range of `T` the value is 0 or infinity. Returns where the number
 * ends, or null when there is none at `p`. White space is not skipped. `*end` must be readable.
 */
template <typename T>
inline const char* ParseNumber(const char* p, const char* end, T& value)
{
  if (p == end)
  {
    return nullptr;
  }
  // Without a branch: signs come at random, so every other one would be mispredicted, at the cost
  // of a fifth of the whole time.
  const bool negative = *p == '-';
  p += negative | (*p == '+');
  if (*p == '-')
  {
    return nullptr;
  }
  const char* after = ParseShortDecimal(p, end, value);
  if (!after)
  {
    const auto result = fast_float::from_chars(p, end, value);
    if (result.ec == std::errc::invalid_argument)
    {
      return nullptr;
    }
    after = result.ptr;
  }
  constexpr T signs[] = { 1, -1 };
  value *= signs[negative];
  return after;
}

/// Whether the number at `p`, which ParseNumber() has read as `value`, is below zero; also if it is
/// so close to zero that `value` is -0.
template <typename T>
inline bool IsNegative(const char* p, const char* end, T value)
{
  if (!std::signbit(value) || value < 0)
  {
    return value < 0;
  }
  const char* const exponent = std::find_if(p, end, [](char c) { return c == 'e' || c == 'E'; });
  return std::any_of(p, exponent, [](char c) { return c >= '1' && c <= '9'; });
}

/// Whether a number read as a double is a count: whole, not negative, and up to 2^53, beyond which
/// doubles skip integers.
inline bool IsCount(double value)
{
  return value >= 0.0 && value <= 0x1p53 && value == std::floor(value);
}

/// Whether an integer is what its digits [begin, end) say, which doubles are not beyond 2^53: those
/// of identifiers of 64 bits are others. True of numbers with a point or an exponent, and of those
/// without digits.
inline bool IsAsWritten(const char* begin, const char* end, double value)
{
  if (!(std::abs(value) > 0x1p53))
  {
    return true;
  }
  const auto isDigit = [](char c) { return c >= '0' && c <= '9'; };
  begin = std::find_if(begin, end, isDigit);
  const char* const last = std::find_if_not(begin, end, isDigit);
  if (begin == last || (last != end && (*last == '.' || *last == 'e' || *last == 'E')))
  {
    return true;
  }
  char digits[std::numeric_limits<double>::max_exponent10 + 2];
  const auto written = std::to_chars(
    std::begin(digits), std::end(digits), std::abs(value), std::chars_format::fixed, 0);
  begin = std::find_if(begin, last, [](char c) { return c != '0'; });
  return std::string_view(begin, last - begin) ==
    std::string_view(std::begin(digits), written.ptr - std::begin(digits));
}

/// The maximum length of what WriteNumber() writes.
constexpr int MaximumNumberLength = 32;

/// Writes the shortest digits that read back as `value`, whatever the locale is; returns their end.
template <typename T>
inline char* WriteNumber(char* p, T value)
{
  return std::to_chars(p, p + MaximumNumberLength, value).ptr;
}

/// What WriteNumber() writes, as a string.
template <typename T>
inline std::string NumberText(T value)
{
  char text[MaximumNumberLength];
  return std::string(text, WriteNumber(text, value));
}
}

#endif
