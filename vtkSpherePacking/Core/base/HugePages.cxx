// SPDX-License-Identifier: BSD-3-Clause
#include "base/HugePages.h"

#ifdef __linux__
#include <sys/mman.h>
#include <unistd.h>

#include <cstdint>
#endif

#include <cstdlib>

namespace spherepacking
{
namespace
{
void* AllocateAligned(std::size_t length)
{
  constexpr std::size_t line = 64;
  return std::aligned_alloc(line, (length + line - 1) / line * line);
}
}

#ifdef __linux__
//------------------------------------------------------------------------------
void AdviseHugePages(void* memory, std::size_t length)
{
  // Only whole pages within the memory may be advised on.
  const auto page = static_cast<std::uintptr_t>(sysconf(_SC_PAGESIZE));
  const auto begin = (reinterpret_cast<std::uintptr_t>(memory) + page - 1) / page * page;
  const auto end = (reinterpret_cast<std::uintptr_t>(memory) + length) / page * page;
  constexpr std::uintptr_t worthwhile = 2 << 20;
  if (end > begin && end - begin >= worthwhile)
  {
    madvise(reinterpret_cast<void*>(begin), end - begin, MADV_HUGEPAGE);
  }
}

//------------------------------------------------------------------------------
void* AllocateHugePages(std::size_t length)
{
  constexpr std::size_t page = 2 << 20;
  if (length < page)
  {
    return AllocateAligned(length);
  }
  void* memory = nullptr;
  if (posix_memalign(&memory, page, length) != 0)
  {
    return nullptr;
  }
  // What is left of the last page stays on small ones, or it would be in memory as a whole.
  AdviseHugePages(memory, length / page * page);
  return memory;
}
#else
//------------------------------------------------------------------------------
void AdviseHugePages(void*, std::size_t) {}

//------------------------------------------------------------------------------
void* AllocateHugePages(std::size_t length)
{
  return AllocateAligned(length);
}
#endif
}
