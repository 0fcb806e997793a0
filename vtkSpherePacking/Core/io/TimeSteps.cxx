// SPDX-License-Identifier: BSD-3-Clause
#include "io/TimeSteps.h"

#include <algorithm>
#include <numeric>

namespace spherepacking
{
//------------------------------------------------------------------------------
TimeSteps::TimeSteps(std::vector<TimeStep> steps)
  : Steps(std::move(steps))
  , Values(this->Steps.size())
{
  // An absent number compares less than any.
  const auto notIncreasing = [](const TimeStep& a, const TimeStep& b)
  { return !b.Time || a.Time >= b.Time; };
  const auto repeated = std::adjacent_find(this->Steps.begin(), this->Steps.end(), notIncreasing);
  if (this->Steps.front().Time && repeated == this->Steps.end())
  {
    std::transform(this->Steps.begin(), this->Steps.end(), this->Values.begin(),
      [](const TimeStep& step) { return *step.Time; });
  }
  else
  {
    std::iota(this->Values.begin(), this->Values.end(), 0.0);
  }
}

//------------------------------------------------------------------------------
std::size_t TimeSteps::IndexOf(const std::optional<double>& value) const
{
  if (!value)
  {
    return 0;
  }
  const auto after = std::upper_bound(this->Values.begin(), this->Values.end(), *value);
  return after == this->Values.begin() ? 0 : after - this->Values.begin() - 1;
}

//------------------------------------------------------------------------------
bool HasSteps(Format format)
{
  return format == Format::Dump || format == Format::Xyz || format == Format::Mercury;
}
}
