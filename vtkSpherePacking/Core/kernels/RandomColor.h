// SPDX-License-Identifier: BSD-3-Clause
/// One colour a sphere, the same in every picture.
#ifndef RandomColor_h
#define RandomColor_h

#include <cstdint>

namespace spherepacking
{
/// Spread evenly by a mixing of the id's bits, and not too dark.
///
/// Source: Steele, Lea and Flood, "Fast Splittable Pseudorandom Number Generators" (2014).
inline void RandomColor(std::uint64_t id, unsigned char* color)
{
  std::uint64_t z = (id + 1) * 0x9e3779b97f4a7c15u;
  z = (z ^ (z >> 30)) * 0xbf58476d1ce4e5b9u;
  z = (z ^ (z >> 27)) * 0x94d049bb133111ebu;
  z ^= z >> 31;
  for (int channel = 0; channel < 3; ++channel)
  {
    color[channel] = static_cast<unsigned char>(64 + ((z >> (8 * channel)) & 0xff) * 3 / 4);
  }
  color[3] = 255;
}
}

#endif
