// SPDX-License-Identifier: BSD-3-Clause
/// A double as the sum of two floats, the form in which doubles reach the shaders.
#ifndef SplitDouble_h
#define SplitDouble_h

#include <cstdint>
#include <cstring>

namespace spherepacking
{
/// Splits `value` into high + low, which is precise to 47 bits within the range of normal floats.
///
/// The high part is truncated rather than rounded. Upstream: GCC 12.2: the SLP vectorizer of -O3
/// takes a conversion from double to float and back, which rounding needs, for no change at all, so
/// that low would be 0 (seen with the nine elements of a matrix, as in SetSpriteUniforms()).
inline void SplitDouble(double value, float& high, float& low)
{
  std::uint64_t bits;
  std::memcpy(&bits, &value, sizeof(bits));
  bits &= ~((std::uint64_t{ 1 } << 29) - 1); // a float has 23 of the 52 bits of the mantissa
  double truncated;
  std::memcpy(&truncated, &bits, sizeof(truncated));
  high = static_cast<float>(truncated);
  low = static_cast<float>(value - truncated);
}
}

#endif
