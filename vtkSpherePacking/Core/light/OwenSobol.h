// SPDX-License-Identifier: BSD-3-Clause
/// Owen-scrambled Sobol points.
///
/// A digit of a coordinate is flipped or not by all digits before it, so that every point is
/// uniform by itself and together they stay as even as Sobol's: of the first 2^(a + b) points of a
/// pair, one lies in each of the 2^a x 2^b equal boxes. Pairs that are not of the same sequence
/// take the points in another order, itself scrambled, so that pairs are uncorrelated.
///
/// Sources: Laine and Karras, "Stratified Sampling for Stochastic Transparency" (2011), for the
/// scrambling; Burley, "Practical Hash-based Owen Scrambling" (2020), for sequences padded with
/// shuffled ones; Vegdahl, "Building a Better LK Hash" (2021), for the constants; Joe and Kuo,
/// "Constructing Sobol Sequences with Better Two-Dimensional Projections" (2008), for the third and
/// fourth coordinate.
#ifndef OwenSobol_h
#define OwenSobol_h

#include "base/MixBits.h"
#include "base/Simd.h"

#include <array>
#include <cstdint>

namespace spherepacking
{
inline namespace SPHEREPACKING_ISA
{
struct Point2
{
  double X;
  double Y;
};

inline std::uint32_t ReverseBits(std::uint32_t x)
{
  x = __builtin_bswap32(x);
  x = ((x >> 4) & 0x0f0f0f0fu) | ((x & 0x0f0f0f0fu) << 4);
  x = ((x >> 2) & 0x33333333u) | ((x & 0x33333333u) << 2);
  return ((x >> 1) & 0x55555555u) | ((x & 0x55555555u) << 1);
}

/// Scrambles a number whose first digit is the last bit, as ReverseBits() makes it.
inline std::uint32_t ScrambleReversed(std::uint32_t x, std::uint32_t seed)
{
  x ^= x * 0x3d20adeau;
  x += seed;
  x *= (seed >> 16) | 1u;
  x ^= x * 0x05526c56u;
  x ^= x * 0x53a22864u;
  return x;
}

inline std::uint32_t Scramble(std::uint32_t x, std::uint32_t seed)
{
  return ReverseBits(ScrambleReversed(ReverseBits(x), seed));
}

/// The second coordinate of Sobol's points, its bits reversed, from the first one.
///
/// Its matrix is Pascal's triangle: the bits of the index are the coefficients of a polynomial over
/// {0, 1}, of which x + 1 is put in for x, halves of halves at a time.
inline std::uint32_t SobolSecondReversed(std::uint32_t index)
{
  index ^= (index >> 1) & 0x55555555u;
  index ^= (index >> 2) & 0x33333333u;
  index ^= (index >> 4) & 0x0f0f0f0fu;
  index ^= (index >> 8) & 0x00ff00ffu;
  return index ^ ((index >> 16) & 0x0000ffffu);
}

/// The columns of a coordinate's matrix, from the primitive polynomial's degree and middle
/// coefficients and the first direction numbers.
template <int Degree>
constexpr std::array<std::uint32_t, 32> SobolColumns(
  unsigned middle, const std::uint32_t (&first)[Degree])
{
  std::array<std::uint32_t, 32> columns{};
  for (int i = 0; i < 32; ++i)
  {
    if (i < Degree)
    {
      columns[i] = first[i] << (31 - i);
      continue;
    }
    std::uint32_t column = columns[i - Degree] ^ (columns[i - Degree] >> Degree);
    for (int k = 1; k < Degree; ++k)
    {
      if ((middle >> (Degree - 1 - k)) & 1u)
      {
        column ^= columns[i - k];
      }
    }
    columns[i] = column;
  }
  return columns;
}

inline std::uint32_t SobolCoordinate(
  std::uint32_t index, const std::array<std::uint32_t, 32>& columns)
{
  std::uint32_t x = 0;
  for (; index != 0; index &= index - 1)
  {
    x ^= columns[__builtin_ctz(index)];
  }
  return x;
}

/// In the open interval from 0 to 1, without bias.
inline double UnitInterval(std::uint32_t x)
{
  return (x + 0.5) * 0x1p-32;
}

/// The points of one pixel, or of a whole picture.
class OwenSobol
{
public:
  explicit OwenSobol(std::uint64_t seed)
    : Seed(seed)
  {
  }

  /// Pairs 0 and 1 together are four-dimensional Sobol points, every other pair stands alone.
  Point2 At(std::uint32_t index, int pair) const
  {
    const std::uint64_t seeds = MixBits(this->Seed + static_cast<std::uint64_t>(pair));
    const auto seedX = static_cast<std::uint32_t>(seeds);
    const auto seedY = static_cast<std::uint32_t>(seeds >> 32);
    if (pair == 1)
    {
      static constexpr std::uint32_t third[] = { 1, 3 };
      static constexpr std::uint32_t fourth[] = { 1, 3, 1 };
      static constexpr auto columnsX = SobolColumns<2>(1, third);
      static constexpr auto columnsY = SobolColumns<3>(1, fourth);
      return { UnitInterval(Scramble(SobolCoordinate(index, columnsX), seedX)),
        UnitInterval(Scramble(SobolCoordinate(index, columnsY), seedY)) };
    }
    if (pair != 0)
    {
      index = Scramble(index, static_cast<std::uint32_t>(MixBits(seeds)));
    }
    return { UnitInterval(ReverseBits(ScrambleReversed(index, seedX))),
      UnitInterval(ReverseBits(ScrambleReversed(SobolSecondReversed(index), seedY))) };
  }

private:
  std::uint64_t Seed;
};
}
}

#endif
