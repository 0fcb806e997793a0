// SPDX-License-Identifier: BSD-3-Clause
#ifndef Charge_h
#define Charge_h

#include <cstdint>

namespace spherepacking
{
/// A point source of the field: a sphere, in coordinates scaled so that the scene is about 1 long.
struct Charge
{
  double Position[3];
  float Strength;  ///< factor of the kernel, see Blobs.h; above 0
  float Radius;    ///< of the sphere
  std::int32_t Id; ///< of the sphere in the packing
};
}

#endif
