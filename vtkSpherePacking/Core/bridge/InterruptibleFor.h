// SPDX-License-Identifier: BSD-3-Clause
#ifndef InterruptibleFor_h
#define InterruptibleFor_h

#include <cstdint>
#include <functional>
#include <vector>

namespace spherepacking
{
/// Calls work(i) for 0 to count - 1 on all cores, and after each report(i, fraction) in the calling
/// thread, with the fraction of them that is done; it says whether to stop. Returns for each i
/// whether its work was done. An exception that leaves the work is thrown again at the end.
std::vector<char> InterruptibleFor(std::int64_t count,
  const std::function<void(std::int64_t)>& work,
  const std::function<bool(std::int64_t, double)>& report);
}

#endif
