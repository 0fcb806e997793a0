// SPDX-License-Identifier: BSD-3-Clause
#include "metaballs/multipole/TranslationIndex.h"

namespace spherepacking
{
namespace
{
DerivativeStep StepTo(const MultiIndex& index, int power, int i, int j, int k)
{
  const auto place = [&](int a, int b, int c)
  { return a < 0 || b < 0 || c < 0 ? index.Count : index(a, b, c); };
  const auto n = static_cast<float>(i + j + k);
  const auto v = static_cast<float>(power);
  DerivativeStep step;
  step.First = -(2.0f * n + v - 2.0f) / n;
  step.Second = -(n + v - 2.0f) / n;
  step.To = place(i, j, k);
  for (int axis = 0; axis < 3; ++axis)
  {
    const int less[3] = { axis == 0, axis == 1, axis == 2 };
    step.One[axis] = place(i - less[0], j - less[1], k - less[2]);
    step.Two[axis] = place(i - 2 * less[0], j - 2 * less[1], k - 2 * less[2]);
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
  : Kept(order, TopOf(power, order))
  , Sums(order, 2 * this->Kept.Top)
{
  for (int degree = 1; degree <= order; ++degree)
  {
    for (int k = 0; k <= std::min(degree, this->Sums.Top); ++k)
    {
      for (int j = 0; j + k <= degree; ++j)
      {
        this->Steps.push_back(StepTo(this->Sums, power, degree - j - k, j, k));
      }
    }
  }
  ForEachMonomial(this->Sums, [this](int i, int j, int k, int)
    { this->Factorials.push_back(Factorial(i) * Factorial(j) * Factorial(k)); });
}
}
