// SPDX-License-Identifier: BSD-3-Clause
#ifndef ParallelFor_h
#define ParallelFor_h

#include <cstdint>
#include <functional>

namespace spherepacking
{
/// Calls `work` with 0 to count - 1, in any order and on as many threads as it likes. What runs in
/// it does not know whose threads these are; bridge/SmpParallelFor.h makes one of vtkSMPTools.
using ParallelFor =
  std::function<void(std::int64_t count, const std::function<void(std::int64_t)>& work)>;
}

#endif
