// SPDX-License-Identifier: BSD-3-Clause
#ifndef HugePages_h
#define HugePages_h

#include <cstddef>

namespace spherepacking
{
/**
 * Asks the system to back fresh memory with large pages where it offers that on request, as Linux
 * does. Filling memory for the first time then costs a fault each 2 MiB rather than each 4 KiB,
 * which otherwise takes as long as parsing does. Only a hint: nothing depends on it.
 */
void AdviseHugePages(void* memory, std::size_t length);

/// Memory for std::free(), aligned to 64 bytes, from the begin to the end on large pages where
/// there are any; null when there is not enough.
void* AllocateHugePages(std::size_t length);
}

#endif
