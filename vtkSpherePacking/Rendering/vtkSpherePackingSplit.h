// SPDX-License-Identifier: BSD-3-Clause
// A double as two floats. Private to the module.
#ifndef vtkSpherePackingSplit_h
#define vtkSpherePackingSplit_h

#include "vtkABINamespace.h"

#include <cstdint>
#include <cstring>

VTK_ABI_NAMESPACE_BEGIN
// high + low is `value` to 47 bits, given that it is within the range of normal floats.
//
// The high part is cut off rather than rounded: gcc 12 at -O3 takes the round trip from double to
// float and back, which rounding needs, for no change at all when it vectorises, and the low part
// would be 0.
inline void vtkSpherePackingSplit(double value, float& high, float& low)
{
  std::uint64_t bits;
  std::memcpy(&bits, &value, sizeof(bits));
  bits &= ~((std::uint64_t{ 1 } << 29) - 1); // a float keeps 23 of the 52 bits
  double cut;
  std::memcpy(&cut, &bits, sizeof(cut));
  high = static_cast<float>(cut);
  low = static_cast<float>(value - cut);
}
VTK_ABI_NAMESPACE_END

#endif
