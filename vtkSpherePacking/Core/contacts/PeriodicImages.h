// SPDX-License-Identifier: BSD-3-Clause
#ifndef PeriodicImages_h
#define PeriodicImages_h

#include "base/Vector3.h"

#include <array>
#include <cstdint>

namespace spherepacking
{
/// How often each of the vectors of a cell is added.
using CellShift = std::array<std::int32_t, 3>;

/**
 * A packing that is repeated along up to three vectors, as the simulation cell of a molecular or
 * granular simulation is along its periodic ones.
 *
 * The vectors need not be orthogonal. Fractions are coordinates along the vectors, from the dual
 * basis within their span; for each the change of a fraction is at most the length of a step times
 * that of the dual vector, so that a ball of radius r spans r `DualLength` to either side.
 */
class PeriodicImages
{
public:
  /// Nothing is repeated.
  PeriodicImages() = default;

  /// Throws a std::invalid_argument if the periodic vectors do not span a cell.
  PeriodicImages(
    const double (&origin)[3], const double (&vectors)[3][3], const std::array<bool, 3>& periodic);

  bool Any() const { return this->Periodic[0] || this->Periodic[1] || this->Periodic[2]; }
  bool IsPeriodic(int axis) const { return this->Periodic[axis]; }

  /// The fraction along a vector, 0 if that is not periodic.
  double Fraction(const Vector3& point, int axis) const
  {
    return Dot(this->Duals[axis], point - this->Origin);
  }
  double DualLength(int axis) const { return Length(this->Duals[axis]); }

  /// The sum of the vectors, each so often, in this order: (a + b) + c.
  Vector3 Sum(const CellShift& shift) const
  {
    return shift[0] * this->Vectors[0] + shift[1] * this->Vectors[1] + shift[2] * this->Vectors[2];
  }

  /// Length of the longest vector.
  double Longest() const;

private:
  std::array<bool, 3> Periodic{ false, false, false };
  Vector3 Origin;
  Vector3 Vectors[3]; // 0 where not periodic, as the duals
  Vector3 Duals[3];
};
}

#endif
