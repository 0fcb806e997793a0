// SPDX-License-Identifier: BSD-3-Clause
// How much memory a structure may take.
#ifndef MemoryLimit_h
#define MemoryLimit_h

#include <vtksys/SystemInformation.hxx>

namespace spherepacking
{
// Half of the machine's memory, in bytes.
inline double HalfOfMemory()
{
  vtksys::SystemInformation system;
  return 0.5 * 1024.0 * static_cast<double>(system.GetHostMemoryTotal());
}
}

#endif
