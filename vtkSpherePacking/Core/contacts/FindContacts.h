// SPDX-License-Identifier: BSD-3-Clause
#ifndef FindContacts_h
#define FindContacts_h

#include "base/HugeArray.h"
#include "base/ParallelFor.h"
#include "base/SphereArrays.h"
#include "contacts/PeriodicImages.h"

#include <cstdint>
#include <functional>

namespace spherepacking
{
/// Two spheres that touch: sphere I, and sphere J moved by so many vectors of the cell.
struct Contact
{
  std::int32_t I;
  std::int32_t J; ///< above I, or I itself with a shift whose first number that is not 0 is above 0
  CellShift Shift;
};

/// From one surface to another, from the vector d between the centres: the distance
/// sqrt((dx dx + dy dy) + dz dz) less the sum of the radii, in double precision. Negative where the
/// spheres overlap.
inline double GapOf(const Vector3& d, double radius, double otherRadius)
{
  return Length(d) - (radius + otherRadius);
}

/// The same of sphere i and sphere j moved by `shift`, d being (j - i) + shift.
inline double GapOf(
  const SphereArrays& spheres, std::int32_t i, std::int32_t j, const Vector3& shift)
{
  const Sphere a = spheres[i];
  const Sphere b = spheres[j];
  return GapOf(Vector3{ b.X - a.X, b.Y - a.Y, b.Z - a.Z } + shift, a.R, b.R);
}

struct ContactWork
{
  ParallelFor For;
  ParallelFor Search; ///< looks for contacts, which takes longest
  double Most;        ///< contacts, above which a std::invalid_argument is thrown
};

/**
 * All contacts of a packing, that is pairs whose GapOf() is at most `gap`, each once, by I, then J,
 * then the shift. Of a periodic packing every image counts: two spheres may touch several times,
 * and a sphere its own image.
 */
HugeArray<Contact> FindContacts(
  const SphereArrays& spheres, double gap, const PeriodicImages& images, const ContactWork& work);
}

#endif
