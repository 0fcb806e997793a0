// SPDX-License-Identifier: BSD-3-Clause
/// ParseShortRows(), see io/ShortRows.h, for processors with AVX2.
#include "base/Simd.h"
#include "io/ShortRows.h"

#include <cstdint>
#include <immintrin.h>

namespace spherepacking
{
namespace
{
constexpr int MaximumWholes = 8;
constexpr int MaximumDecimals = 7;

/// Moves the digits of a number, from where it begins, to the end of 16 bytes, without its point.
struct DigitShuffles
{
  constexpr DigitShuffles()
  {
    for (int wholes = 1; wholes <= MaximumWholes; ++wholes)
    {
      for (int decimals = 0; decimals <= MaximumDecimals; ++decimals)
      {
        const int digits = wholes + decimals;
        for (int i = 0; i < 16; ++i)
        {
          const int digit = i - (16 - digits);
          this->At[wholes - 1][decimals][i] = static_cast<std::int8_t>(
            digit < 0 ? -1 : digit + (digit >= wholes)); // the highest bit gives a zero
        }
      }
    }
  }

  alignas(16) std::int8_t At[MaximumWholes][MaximumDecimals + 1][16]{};
};
constexpr DigitShuffles Shuffles;

// By sign and number of decimals.
constexpr double Divisors[2][MaximumDecimals + 1] = { { 1e0, 1e1, 1e2, 1e3, 1e4, 1e5, 1e6, 1e7 },
  { -1e0, -1e1, -1e2, -1e3, -1e4, -1e5, -1e6, -1e7 } };

/// Where the four numbers of a row lie.
struct RowMarks
{
  int Begin[4]; ///< without the sign
  int Wholes[4];
  int Decimals[4];
  int Negative[4];
  int End; ///< of the line
};

struct Bytes64
{
  __m256i Low;
  __m256i High;

  std::uint64_t Equal(char c) const
  {
    const __m256i wanted = _mm256_set1_epi8(c);
    return Bits(_mm256_cmpeq_epi8(this->Low, wanted), _mm256_cmpeq_epi8(this->High, wanted));
  }

  std::uint64_t Digits() const
  {
    // '0' to '9' become the ten largest signed bytes.
    const __m256i shift = _mm256_set1_epi8(127 - '9');
    const __m256i bound = _mm256_set1_epi8(127 - 10);
    return Bits(_mm256_cmpgt_epi8(_mm256_add_epi8(this->Low, shift), bound),
      _mm256_cmpgt_epi8(_mm256_add_epi8(this->High, shift), bound));
  }

private:
  static std::uint64_t Bits(__m256i low, __m256i high)
  {
    return static_cast<std::uint32_t>(_mm256_movemask_epi8(low)) |
      static_cast<std::uint64_t>(static_cast<std::uint32_t>(_mm256_movemask_epi8(high))) << 32;
  }
};

// Points and ends are looked for by themselves; that each number has its own follows from their
// order, and that nothing else stands between from their number.
SPHEREPACKING_INLINE bool FindMarks(const char* p, RowMarks& row)
{
  const Bytes64 text{ _mm256_loadu_si256(reinterpret_cast<const __m256i*>(p)),
    _mm256_loadu_si256(reinterpret_cast<const __m256i*>(p + 32)) };
  const std::uint64_t lineEnds = text.Equal('\n') | text.Equal('\r');
  if (lineEnds == 0)
  {
    return false;
  }
  const std::uint64_t line = lineEnds ^ (lineEnds - 1); // up to and with the first
  std::uint64_t ends = (text.Equal(' ') | lineEnds) & line;
  std::uint64_t points = text.Equal('.') & line;
  const std::uint64_t signs = text.Equal('-') & (ends << 1 | 1);
  const std::uint64_t marks = ~text.Digits() & ~signs & line;
  if (__builtin_popcountll(marks) != 8 || __builtin_popcountll(points) != 4 ||
    __builtin_popcountll(ends) != 4)
  {
    return false;
  }
  unsigned int wrong = 0;
  int begin = 0;
  for (int i = 0; i < 4; ++i)
  {
    const int point = __builtin_ctzll(points);
    const int end = __builtin_ctzll(ends);
    points &= points - 1;
    ends &= ends - 1;
    row.Negative[i] = static_cast<int>(signs >> begin & 1);
    row.Begin[i] = begin + row.Negative[i];
    row.Wholes[i] = point - row.Begin[i];
    row.Decimals[i] = end - point - 1;
    wrong |= static_cast<unsigned int>((row.Wholes[i] - 1) | row.Decimals[i]);
    begin = end + 1;
  }
  row.End = begin - 1;
  static_assert(MaximumWholes == 8 && MaximumDecimals == 7);
  return wrong < 8; // a negative one has become large
}

SPHEREPACKING_INLINE __m128i LoadDigits16(const char* p, const RowMarks& row, int i)
{
  const __m128i text = _mm_loadu_si128(reinterpret_cast<const __m128i*>(p + row.Begin[i]));
  const __m128i shuffle = _mm_load_si128(
    reinterpret_cast<const __m128i*>(Shuffles.At[row.Wholes[i] - 1][row.Decimals[i]]));
  return _mm_shuffle_epi8(_mm_sub_epi8(text, _mm_set1_epi8('0')), shuffle);
}

// All digits of the four numbers as integers, at most 15 each, which doubles hold exactly. As in
// EightDigits() of io/ShortDecimal.h, digits are joined to twos, fours and eights.
SPHEREPACKING_INLINE __m256d Integers(const char* p, const RowMarks& row)
{
  const __m256i even = _mm256_set_m128i(LoadDigits16(p, row, 2), LoadDigits16(p, row, 0));
  const __m256i odd = _mm256_set_m128i(LoadDigits16(p, row, 3), LoadDigits16(p, row, 1));
  const __m256i tens = _mm256_set1_epi16(0x010A);
  const __m256i hundreds = _mm256_set1_epi32(0x00010064);
  const __m256i ten4 = _mm256_set1_epi32(0x00012710);
  const __m256i fours =
    _mm256_packus_epi32(_mm256_madd_epi16(_mm256_maddubs_epi16(even, tens), hundreds),
      _mm256_madd_epi16(_mm256_maddubs_epi16(odd, tens), hundreds));
  const __m256i eights = _mm256_madd_epi16(fours, ten4); // the leading ones in even places
  // An integer below 2^32 in the mantissa of 2^52 is that much above it.
  const __m256i two52 = _mm256_set1_epi64x(0x4330000000000000);
  const __m256i leading = _mm256_blend_epi32(eights, two52, 0xAA);
  const __m256i trailing = _mm256_or_si256(_mm256_srli_epi64(eights, 32), two52);
  const __m256d zero = _mm256_castsi256_pd(two52);
  return _mm256_add_pd(
    _mm256_mul_pd(_mm256_sub_pd(_mm256_castsi256_pd(leading), zero), _mm256_set1_pd(1e8)),
    _mm256_sub_pd(_mm256_castsi256_pd(trailing), zero));
}

SPHEREPACKING_INLINE __m256d DivisorsOf(const RowMarks& row)
{
  const auto of = [&row](int i) { return Divisors[row.Negative[i]][row.Decimals[i]]; };
  return _mm256_set_pd(of(3), of(2), of(1), of(0));
}

// One division rounds once. False if that is not so, or the radius is negative.
SPHEREPACKING_INLINE bool StoreRow(
  const char* p, const RowMarks& row, double* center, double* radius)
{
  const __m256d values = _mm256_div_pd(Integers(p, row), DivisorsOf(row));
  const __m128d zr = _mm256_extractf128_pd(values, 1);
  _mm_storeu_pd(center, _mm256_castpd256_pd128(values));
  _mm_storel_pd(center + 2, zr);
  _mm_storeh_pd(radius, zr);
  return !(*radius < 0.0);
}

SPHEREPACKING_INLINE bool StoreRow(const char* p, const RowMarks& row, float* center, float* radius)
{
  const __m256d integers = Integers(p, row);
  const __m256d exact = _mm256_cmp_pd(integers, _mm256_set1_pd(0x1p24), _CMP_LE_OQ);
  if (_mm256_movemask_pd(exact) != 0xF)
  {
    return false;
  }
  alignas(16) float values[4];
  _mm_store_ps(values, _mm_div_ps(_mm256_cvtpd_ps(integers), _mm256_cvtpd_ps(DivisorsOf(row))));
  center[0] = values[0];
  center[1] = values[1];
  center[2] = values[2];
  *radius = values[3];
  return !(*radius < 0.0f);
}

template <typename Real>
const char* ParseRows(const char* p, const char* end, Real* centers, Real* radii, long long& count)
{
  constexpr int readable = 64 + 16; // from where the last number begins, 16 bytes are loaded
  Real* center = centers;
  Real* radius = radii;
  RowMarks row;
  while (end - p >= readable && FindMarks(p, row) && StoreRow(p, row, center, radius))
  {
    p += row.End + 1;
    p += p[-1] == '\r' && *p == '\n';
    center += 3;
    ++radius;
  }
  count = radius - radii;
  return p;
}
}

//------------------------------------------------------------------------------
const char* ParseShortRowsAvx2(
  const char* p, const char* end, double* centers, double* radii, long long& count)
{
  return ParseRows(p, end, centers, radii, count);
}

//------------------------------------------------------------------------------
const char* ParseShortRowsAvx2(
  const char* p, const char* end, float* centers, float* radii, long long& count)
{
  return ParseRows(p, end, centers, radii, count);
}
}
