// SPDX-License-Identifier: BSD-3-Clause
#ifndef PowerDerivatives_h
#define PowerDerivatives_h

#include "base/Simd.h"
#include "metaballs/multipole/TranslationIndex.h"

namespace spherepacking
{
inline namespace SPHEREPACKING_ISA
{
/// Derivatives of |R|^-power at unit vectors (x, y, z), those of `index.Sums`, eight at once.
/// `derivatives` has room for one more.
inline void PowerDerivatives(const TranslationIndex& index, const Float8& x, const Float8& y,
  const Float8& z, Float8* derivatives)
{
  const int count = index.Sums.Count;
  derivatives[0] = Float8{} + 1.0f;
  derivatives[count] = Float8{};
  const DerivativeStep* steps = index.Steps.data();
  for (int i = 0; i < count - 1; ++i)
  {
    const DerivativeStep& step = steps[i];
    const Float8 one =
      x * derivatives[step.One[0]] + y * derivatives[step.One[1]] + z * derivatives[step.One[2]];
    const Float8 two =
      derivatives[step.Two[0]] + derivatives[step.Two[1]] + derivatives[step.Two[2]];
    derivatives[step.To] = step.First * one + step.Second * two;
  }
  const float* factorials = index.Factorials.data();
  for (int place = 0; place < count; ++place)
  {
    derivatives[place] *= factorials[place];
  }
}
}
}

#endif
