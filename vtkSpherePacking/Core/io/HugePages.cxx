// SPDX-License-Identifier: BSD-3-Clause
#include "io/HugePages.h"

#ifdef __linux__
#include <sys/mman.h>
#include <unistd.h>

#include <cstdint>
#endif

namespace spherepacking
{
#ifdef __linux__
//------------------------------------------------------------------------------
void AdviseHugePages(void* memory, std::size_t length)
{
  // Only whole pages within the memory may be advised on.
  const auto page = static_cast<std::uintptr_t>(sysconf(_SC_PAGESIZE));
  const auto begin = (reinterpret_cast<std::uintptr_t>(memory) + page - 1) / page * page;
  const auto end = (reinterpret_cast<std::uintptr_t>(memory) + length) / page * page;
  constexpr std::uintptr_t worthwhile = 4 << 20;
  if (end > begin && end - begin >= worthwhile)
  {
    madvise(reinterpret_cast<void*>(begin), end - begin, MADV_HUGEPAGE);
  }
}
#else
//------------------------------------------------------------------------------
void AdviseHugePages(void*, std::size_t) {}
#endif
}
