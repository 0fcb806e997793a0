// SPDX-License-Identifier: BSD-3-Clause
#ifndef SphereArrays_h
#define SphereArrays_h

#include "base/Sphere.h"

#include <cstdint>

namespace spherepacking
{
/// A view of the spheres of a packing, in single or double precision, without a copy.
struct SphereArrays
{
  std::int64_t Count = 0;
  const float* FloatCenters =
    nullptr; ///< x, y, z of one after the other; null if in double precision
  const double* DoubleCenters = nullptr;
  const float* FloatRadii = nullptr;
  const double* DoubleRadii = nullptr;

  bool Single() const { return this->FloatCenters && this->FloatRadii; }

  /// Prefetches sphere i.
  void Prefetch(std::int64_t i) const
  {
    if (this->FloatCenters)
    {
      __builtin_prefetch(this->FloatCenters + 3 * i);
    }
    else
    {
      __builtin_prefetch(this->DoubleCenters + 3 * i);
    }
    if (this->FloatRadii)
    {
      __builtin_prefetch(this->FloatRadii + i);
    }
    else
    {
      __builtin_prefetch(this->DoubleRadii + i);
    }
  }

  Sphere operator[](std::int64_t i) const
  {
    Sphere sphere;
    if (this->FloatCenters)
    {
      const float* center = this->FloatCenters + 3 * i;
      sphere.X = center[0];
      sphere.Y = center[1];
      sphere.Z = center[2];
    }
    else
    {
      const double* center = this->DoubleCenters + 3 * i;
      sphere.X = center[0];
      sphere.Y = center[1];
      sphere.Z = center[2];
    }
    sphere.R = this->FloatRadii ? this->FloatRadii[i] : this->DoubleRadii[i];
    return sphere;
  }
};
}

#endif
