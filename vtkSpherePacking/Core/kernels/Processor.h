// SPDX-License-Identifier: BSD-3-Clause
#ifndef Processor_h
#define Processor_h

#include <cstdlib>

namespace spherepacking
{
/// Whether what was compiled for processors with AVX2 and fused multiplication and addition is
/// there and runs on this one.
inline bool HasAvx2()
{
#if defined(SPHEREPACKING_HAS_AVX2)
  // The variable is for tests, which compare both.
  static const bool has = __builtin_cpu_supports("avx2") && __builtin_cpu_supports("fma") &&
    !std::getenv("SPHEREPACKING_WITHOUT_AVX2");
  return has;
#else
  return false;
#endif
}
}

#endif
