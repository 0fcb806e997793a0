// SPDX-License-Identifier: BSD-3-Clause
#include "contacts/PeriodicImages.h"

#include <algorithm>
#include <sstream>
#include <stdexcept>

namespace spherepacking
{
namespace
{
// What of a vector is orthogonal to others, of which those that are 0 do not count.
Vector3 OrthogonalPart(const Vector3& vector, const Vector3& other, const Vector3& another)
{
  const Vector3 normal = Cross(other, another);
  const double square = Dot(normal, normal);
  if (square > 0.0)
  {
    return Dot(vector, normal) / square * normal;
  }
  const Vector3& single = Dot(other, other) > 0.0 ? other : another;
  const double length = Dot(single, single);
  return length > 0.0 ? vector - Dot(vector, single) / length * single : vector;
}
}

//------------------------------------------------------------------------------
PeriodicImages::PeriodicImages(
  const double (&origin)[3], const double (&vectors)[3][3], const std::array<bool, 3>& periodic)
  : Periodic(periodic)
  , Origin{ origin[0], origin[1], origin[2] }
{
  for (int k = 0; k < 3; ++k)
  {
    if (periodic[k])
    {
      this->Vectors[k] = { vectors[k][0], vectors[k][1], vectors[k][2] };
    }
  }
  for (int k = 0; k < 3; ++k)
  {
    if (!periodic[k])
    {
      continue;
    }
    const Vector3 part =
      OrthogonalPart(this->Vectors[k], this->Vectors[(k + 1) % 3], this->Vectors[(k + 2) % 3]);
    const double length = Length(this->Vectors[k]);
    // A cell as flat as this is one by rounding only. The negation is for NaN.
    if (!(Length(part) > 1e-10 * length && length > 1e-100 && length < 1e100))
    {
      std::ostringstream message;
      message << "cell_vectors: found the periodic vector " << this->Vectors[k].X << " "
              << this->Vectors[k].Y << " " << this->Vectors[k].Z
              << ", expected a finite one of some length that the others do not span";
      throw std::invalid_argument(message.str());
    }
    this->Duals[k] = 1.0 / Dot(part, part) * part;
  }
}

//------------------------------------------------------------------------------
double PeriodicImages::Longest() const
{
  return std::max({ Length(this->Vectors[0]), Length(this->Vectors[1]), Length(this->Vectors[2]) });
}
}
