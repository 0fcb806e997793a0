// SPDX-License-Identifier: BSD-3-Clause
#include "io/TimeSteps.h"

#include <algorithm>
#include <cstddef>
#include <numeric>

namespace spherepacking
{
//------------------------------------------------------------------------------
void SetTimes(std::vector<TimeStep>& steps, const std::vector<StepNumbers>& numbers)
{
  const auto has = [](std::size_t which)
  { return [which](const StepNumbers& step) { return step[which].has_value(); }; };
  const auto allHave = [&](std::size_t which)
  { return std::all_of(numbers.begin(), numbers.end(), has(which)); };
  const auto increases = [&](std::size_t which)
  {
    return allHave(which) &&
      std::adjacent_find(numbers.begin(), numbers.end(),
        [which](const auto& a, const auto& b) { return a[which] >= b[which]; }) == numbers.end();
  };
  const auto anyHas = [&](std::size_t which)
  { return std::any_of(numbers.begin(), numbers.end(), has(which)); };

  const std::array<std::size_t, 3> order{ 0, 1, 2 };
  auto chosen = std::find_if(order.begin(), order.end(), increases);
  chosen = chosen == order.end() ? std::find_if(order.begin(), order.end(), allHave) : chosen;
  chosen = chosen == order.end() ? std::find_if(order.begin(), order.end(), anyHas) : chosen;
  for (std::size_t i = 0; chosen != order.end() && i < steps.size(); ++i)
  {
    steps[i].Time = numbers[i][*chosen];
  }
}

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
