// SPDX-License-Identifier: BSD-3-Clause
#ifndef LocalVector_h
#define LocalVector_h

#include "base/Simd.h"

#include <memory>
#include <vector>

namespace spherepacking
{
inline namespace SPHEREPACKING_ISA
{
template <typename T>
struct LocalAllocator : std::allocator<T>
{
  template <typename Other>
  struct rebind
  {
    using other = LocalAllocator<Other>;
  };
};

/// A std::vector whose functions the linker does not take for those of other vectors, which were
/// compiled for another processor.
template <typename T>
using LocalVector = std::vector<T, LocalAllocator<T>>;
}
}

#endif
