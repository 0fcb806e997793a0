// SPDX-License-Identifier: BSD-3-Clause
#include "metaballs/multipole/TranslationIndex.h"

namespace spherepacking
{
namespace
{
DerivativeStep StepTo(const MultiIndex& index, int power, int i, int j, int k)
{
  const auto position = [&](int a, int b, int c)
  { return a < 0 || b < 0 || c < 0 ? index.Count : index(a, b, c); };
  const auto n = static_cast<float>(i + j + k);
  const auto v = static_cast<float>(power);
  DerivativeStep step;
  step.FirstFactor = -(2.0f * n + v - 2.0f) / n;
  step.SecondFactor = -(n + v - 2.0f) / n;
  step.To = position(i, j, k);
  for (int axis = 0; axis < 3; ++axis)
  {
    const int unit[3] = { axis == 0, axis == 1, axis == 2 };
    step.OneLess[axis] = position(i - unit[0], j - unit[1], k - unit[2]);
    step.TwoLess[axis] = position(i - 2 * unit[0], j - 2 * unit[1], k - 2 * unit[2]);
  }
  return step;
}

float Factorial(int n)
{
  return n < 2 ? 1.0f : static_cast<float>(n) * Factorial(n - 1);
}
}

//------------------------------------------------------------------------------
TranslationIndex::TranslationIndex(int power, int order)
  : Reduced(order, ZDegreeOf(power, order))
  , Derivatives(order, 2 * this->Reduced.ZDegree)
{
  for (int degree = 1; degree <= order; ++degree)
  {
    for (int k = 0; k <= std::min(degree, this->Derivatives.ZDegree); ++k)
    {
      for (int j = 0; j + k <= degree; ++j)
      {
        this->Steps.push_back(StepTo(this->Derivatives, power, degree - j - k, j, k));
      }
    }
  }
  ForEachMonomial(this->Derivatives, [this](int i, int j, int k, int)
    { this->Factorials.push_back(Factorial(i) * Factorial(j) * Factorial(k)); });
}
}
