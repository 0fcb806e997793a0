// SPDX-License-Identifier: BSD-3-Clause
/// A number from another, every bit of which depends on all bits of that.
#ifndef MixBits_h
#define MixBits_h

#include <cstdint>

namespace spherepacking
{
/// Source: Steele, Lea and Flood, "Fast Splittable Pseudorandom Number Generators" (2014).
inline std::uint64_t MixBits(std::uint64_t z)
{
  z += 0x9e3779b97f4a7c15u;
  z = (z ^ (z >> 30)) * 0xbf58476d1ce4e5b9u;
  z = (z ^ (z >> 27)) * 0x94d049bb133111ebu;
  return z ^ (z >> 31);
}
}

#endif
