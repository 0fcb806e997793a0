// SPDX-License-Identifier: BSD-3-Clause
#include "bridge/CoordinateRange.h"

#include "bridge/Limits.h"

#include <algorithm>
#include <cmath>
#include <sstream>
#include <stdexcept>

namespace spherepacking
{
//------------------------------------------------------------------------------
void CheckFinite(const double (&bounds)[6])
{
  for (int axis = 0; axis < 3; ++axis)
  {
    if (!std::isfinite(bounds[2 * axis + 1] - bounds[2 * axis]))
    {
      std::ostringstream message;
      message << "packing: found spheres from " << bounds[2 * axis] << " to "
              << bounds[2 * axis + 1] << " along " << "xyz"[axis]
              << ", expected a length that double precision can hold";
      throw std::invalid_argument(message.str());
    }
  }
}

//------------------------------------------------------------------------------
void CheckCoordinateRange(const double (&bounds)[6])
{
  CheckFinite(bounds);
  double length = 0.0;
  double farthest = 0.0;
  for (int axis = 0; axis < 3; ++axis)
  {
    const double low = bounds[2 * axis];
    const double high = bounds[2 * axis + 1];
    length = std::max(length, high - low);
    farthest = std::max(farthest, std::max(std::abs(low), std::abs(high)));
  }
  // Spheres of radius 0 at one point are not seen anyway.
  if (farthest > MaxCoordinate || (length > 0.0 && length < MinLength))
  {
    std::ostringstream message;
    message << "packing: found spheres over a length of " << length << " at coordinates up to "
            << farthest << ", expected a length from " << MinLength << " on and coordinates up to "
            << MaxCoordinate;
    throw std::invalid_argument(message.str());
  }
}
}
