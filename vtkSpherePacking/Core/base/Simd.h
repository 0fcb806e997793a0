// SPDX-License-Identifier: BSD-3-Clause
/// Eight floats, or four doubles, that are worked on at once.
///
/// The vectors of GCC and Clang, which split what the processor does not have. Everything that is
/// built on them lies in the namespace SPHEREPACKING_ISA, since it is compiled once for any
/// processor and once for those with AVX2, and the linker must not take one for the other.
#ifndef Simd_h
#define Simd_h

#include <cmath>
#include <cstdint>
#include <cstring>

#if defined(__SSE2__)
#include <immintrin.h>
#endif

#ifndef SPHEREPACKING_ISA
#define SPHEREPACKING_ISA AnyProcessor
#endif

/// Always inlined: for functions outside of that namespace, so that nobody calls what was compiled
/// for another processor.
#define SPHEREPACKING_INLINE inline __attribute__((always_inline))

namespace spherepacking
{
inline namespace SPHEREPACKING_ISA
{
using Float8 = float __attribute__((vector_size(32)));
using Int8 = std::int32_t __attribute__((vector_size(32)));
using Double4 = double __attribute__((vector_size(32)));
using Long4 = std::int64_t __attribute__((vector_size(32)));

template <typename VectorT, typename Value>
inline VectorT Load(const Value* from)
{
  VectorT vector;
  std::memcpy(&vector, from, sizeof(vector));
  return vector;
}

template <typename VectorT, typename Value>
inline void Store(const VectorT& vector, Value* to)
{
  std::memcpy(to, &vector, sizeof(vector));
}

/// The same element of eight arrays.
inline Float8 Gather(const float* const (&from)[8], int at)
{
  return Float8{ from[0][at], from[1][at], from[2][at], from[3][at], from[4][at], from[5][at],
    from[6][at], from[7][at] };
}

/// Element i is the sum of the elements of vectors[i], for eight vectors.
inline Float8 SumsOfLanes(const Float8* vectors)
{
#if defined(__AVX__)
  const auto add = [](const Float8& a, const Float8& b) { return _mm256_hadd_ps(a, b); };
  const Float8 low =
    add(add(vectors[0], vectors[1]), add(vectors[2], vectors[3])); // of four lanes each
  const Float8 high = add(add(vectors[4], vectors[5]), add(vectors[6], vectors[7]));
  return _mm256_permute2f128_ps(low, high, 0x20) + _mm256_permute2f128_ps(low, high, 0x31);
#else
  Float8 sums = {};
  for (int i = 0; i < 8; ++i)
  {
    for (int lane = 0; lane < 8; ++lane)
    {
      sums[i] += vectors[i][lane];
    }
  }
  return sums;
#endif
}

/// Bit i is set where element i of a comparison's result is true.
inline unsigned Bits(const Int8& mask)
{
#if defined(__AVX__)
  return static_cast<unsigned>(_mm256_movemask_ps(reinterpret_cast<__m256>(mask)));
#else
  unsigned bits = 0;
  for (int i = 0; i < 8; ++i)
  {
    bits |= static_cast<unsigned>(mask[i] & 1) << i;
  }
  return bits;
#endif
}

/// Whether any element of a comparison's result is true.
inline bool Any(const Long4& mask)
{
#if defined(__AVX__)
  return _mm256_movemask_pd(reinterpret_cast<__m256d>(mask)) != 0;
#else
  return (mask[0] | mask[1] | mask[2] | mask[3]) != 0;
#endif
}
inline bool Any(bool mask)
{
  return mask;
}

inline Float8 Sqrt(const Float8& x)
{
#if defined(__AVX__)
  return _mm256_sqrt_ps(x);
#else
  Float8 result;
  for (int i = 0; i < 8; ++i)
  {
    result[i] = std::sqrt(x[i]);
  }
  return result;
#endif
}
inline Double4 Sqrt(const Double4& x)
{
#if defined(__AVX__)
  return _mm256_sqrt_pd(x);
#else
  return Double4{ std::sqrt(x[0]), std::sqrt(x[1]), std::sqrt(x[2]), std::sqrt(x[3]) };
#endif
}
inline double Sqrt(double x)
{
  return std::sqrt(x);
}
}
}

#endif
