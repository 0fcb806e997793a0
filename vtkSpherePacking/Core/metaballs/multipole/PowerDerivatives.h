// SPDX-License-Identifier: BSD-3-Clause
#ifndef PowerDerivatives_h
#define PowerDerivatives_h

#include "base/Simd.h"
#include "metaballs/multipole/TranslationIndex.h"

namespace spherepacking
{
inline namespace SPHEREPACKING_ISA
{
/// Sets the derivatives of |R|^-power at eight unit vectors (x, y, z), by `index.Derivatives`. The
/// array has one element more, which becomes 0.
inline void PowerDerivatives(const TranslationIndex& index, const Float8& x, const Float8& y,
  const Float8& z, Float8* derivatives)
{
  const int count = index.Derivatives.Count;
  derivatives[0] = Float8{} + 1.0f;
  derivatives[count] = Float8{};
  const DerivativeStep* steps = index.Steps.data();
  for (int i = 0; i < count - 1; ++i)
  {
    const DerivativeStep& step = steps[i];
    const Float8 first = x * derivatives[step.OneLess[0]] + y * derivatives[step.OneLess[1]] +
      z * derivatives[step.OneLess[2]];
    const Float8 second =
      derivatives[step.TwoLess[0]] + derivatives[step.TwoLess[1]] + derivatives[step.TwoLess[2]];
    derivatives[step.To] = step.FirstFactor * first + step.SecondFactor * second;
  }
  const float* factorials = index.Factorials.data();
  for (int n = 0; n < count; ++n)
  {
    derivatives[n] *= factorials[n];
  }
}
}
}

#endif
