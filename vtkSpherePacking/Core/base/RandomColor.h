// SPDX-License-Identifier: BSD-3-Clause
/// One colour per sphere, the same in every picture.
#ifndef RandomColor_h
#define RandomColor_h

#include "base/MixBits.h"

#include <cstdint>

namespace spherepacking
{
/// Spread evenly by a mixing of the id's bits, and not too dark.
inline void RandomColor(std::uint64_t id, unsigned char* color)
{
  const std::uint64_t z = MixBits(id * 0x9e3779b97f4a7c15u);
  for (int channel = 0; channel < 3; ++channel)
  {
    color[channel] = static_cast<unsigned char>(64 + ((z >> (8 * channel)) & 0xff) * 3 / 4);
  }
  color[3] = 255;
}
}

#endif
