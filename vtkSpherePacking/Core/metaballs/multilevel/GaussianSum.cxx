// SPDX-License-Identifier: BSD-3-Clause
#include "metaballs/multilevel/GaussianSum.h"

#include <cmath>

namespace spherepacking
{
namespace
{
constexpr double AlphaTimesStep = 0.55;
// The rest of the sum is below a double's rounding.
constexpr int Enough = 200;
}

//------------------------------------------------------------------------------
GaussianSum::GaussianSum(int power, double step)
  : Reach((power == 1 ? 2.8 : 3.2) / std::sqrt(2.0) * step / AlphaTimesStep)
  , Power(power)
  , Step(step)
  , Alpha(AlphaTimesStep / step)
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
double GaussianSum::Variance(int m) const
{
  return 0.5 / (this->Rate(m) * this->Rate(m));
}

//------------------------------------------------------------------------------
double GaussianSum::SpreadOf(int mesh) const
{
  return mesh == 0 ? 0.25 / (this->Alpha * this->Alpha)
                   : std::exp2(2.0 * mesh) * this->Step * this->Step;
}

//------------------------------------------------------------------------------
double GaussianSum::Smooth(double distance) const
{
  double sum = 0.0;
  for (int m = 0; m < Enough; ++m)
  {
    const double away = this->Rate(m) * distance;
    sum += this->Weight(m) * std::exp(-away * away);
  }
  return sum;
}

//------------------------------------------------------------------------------
void GaussianSum::Rest(int first, double& rate, double& weight) const
{
  // Right to the square of the distance.
  double square = 0.0;
  weight = 0.0;
  for (int m = first; m < first + Enough; ++m)
  {
    weight += this->Weight(m);
    square += this->Weight(m) * this->Rate(m) * this->Rate(m);
  }
  rate = std::sqrt(square / weight);
}
}
