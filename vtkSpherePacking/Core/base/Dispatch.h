// SPDX-License-Identifier: BSD-3-Clause
/// Which of two builds of a function runs: the one for processors with AVX2 or the one for any.
#ifndef Dispatch_h
#define Dispatch_h

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

/// Pointer to `function`Avx2, which is compiled for AVX2, where that runs, else to `function`Impl,
/// which is compiled for any processor. Both have the same parameters.
#if defined(SPHEREPACKING_HAS_AVX2)
#define SPHEREPACKING_DISPATCH(function) (HasAvx2() ? &function##Avx2 : &function##Impl)
#else
#define SPHEREPACKING_DISPATCH(function) (&function##Impl)
#endif

#endif
