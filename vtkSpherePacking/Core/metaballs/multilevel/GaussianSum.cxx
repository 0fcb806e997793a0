// SPDX-License-Identifier: BSD-3-Clause
#include "metaballs/multilevel/GaussianSum.h"

#include <cmath>

namespace spherepacking
{
namespace
{
constexpr double AlphaTimesSpacing = 0.55;
// The terms from here on are below the rounding of a double.
constexpr int Terms = 200;
}

//------------------------------------------------------------------------------
GaussianSum::GaussianSum(int power, double spacing)
  : Cutoff((power == 1 ? 2.8 : 3.2) / std::sqrt(2.0) * spacing / AlphaTimesSpacing)
  , Power(power)
  , Spacing(spacing)
  , Alpha(AlphaTimesSpacing / spacing)
{
}

//------------------------------------------------------------------------------
double GaussianSum::Rate(int m) const
{
  return this->Alpha * std::exp2(-0.5 * m);
}

//------------------------------------------------------------------------------
double GaussianSum::Weight(int m) const
{
  const double step = 0.5 * std::log(2.0);
  return 2.0 * step / std::tgamma(0.5 * this->Power) * std::pow(this->Rate(m), this->Power);
}

//------------------------------------------------------------------------------
double GaussianSum::ChargeVariance(int level) const
{
  return level == 0 ? 0.25 / (this->Alpha * this->Alpha)
                    : std::exp2(2.0 * level) * this->Spacing * this->Spacing;
}

//------------------------------------------------------------------------------
double GaussianSum::LongRange(double distance) const
{
  double sum = 0.0;
  for (int m = 0; m < Terms; ++m)
  {
    const double x = this->Rate(m) * distance;
    sum += this->Weight(m) * std::exp(-x * x);
  }
  return sum;
}

//------------------------------------------------------------------------------
void GaussianSum::MergeTerms(int first, double& rate, double& weight) const
{
  // The sum of the weights, and the sum of the coefficients of d^2, stay the same.
  double square = 0.0;
  weight = 0.0;
  for (int m = first; m < first + Terms; ++m)
  {
    weight += this->Weight(m);
    square += this->Weight(m) * this->Rate(m) * this->Rate(m);
  }
  rate = std::sqrt(square / weight);
}
}
