// SPDX-License-Identifier: BSD-3-Clause
#ifndef MemoryLimit_h
#define MemoryLimit_h

#include <vtksys/SystemInformation.hxx>

namespace spherepacking
{
/// Half of the machine's memory in bytes, the most that a structure may take.
inline double HalfOfMemory()
{
  vtksys::SystemInformation system;
  return 0.5 * 1024.0 * static_cast<double>(system.GetHostMemoryTotal());
}
}

#endif
