// SPDX-License-Identifier: BSD-3-Clause
#ifndef ClearanceBound_h
#define ClearanceBound_h

#include "base/Vector3.h"

#include <algorithm>

namespace spherepacking
{
/// An upper bound of the least of several distances, everywhere in a ball.
///
/// Away by u from the ball's middle, the distance to a sphere whose centre is at -a is at most
/// |a| + n u + u^2 / (2 |a|) less its radius, where n = a / |a|, as the square root is concave. The
/// least of several is no more than any mean of theirs with weights w: at most the mean of the
/// distances in the middle, plus h |mean of n|, plus the mean of h^2 / (2 |a|), for the ball's
/// radius h. Weights for which the mean of n is short are found step by step, as in "An algorithm
/// for quadratic programming" (Frank and Wolfe, 1956): where spheres are all around, the bound is
/// hardly above the distance.
class ClearanceBound
{
public:
  explicit ClearanceBound(double radius)
    : Radius(radius)
  {
  }

  /// A sphere by the way from its centre to the middle of the ball, |way| = length. More than
  /// there is room for are left out, which makes the bound no lower.
  void Add(const Vector3& way, double length, double sphereRadius)
  {
    if (this->Count == MostSpheres || !(length > 0.0))
    {
      return;
    }
    this->Normals[this->Count] = (1.0 / length) * way;
    this->Distances[this->Count] =
      length - sphereRadius + this->Radius * this->Radius / (2.0 * length);
    ++this->Count;
  }

  /// A plane by the distance of the ball's middle and the direction in which it grows.
  void AddPlane(const Vector3& normal, double distance)
  {
    this->Normals[this->Count] = normal;
    this->Distances[this->Count] = distance;
    ++this->Count;
  }

  double Value() const
  {
    if (this->Count == 0)
    {
      return 1e300;
    }
    const int first = static_cast<int>(
      std::min_element(this->Distances, this->Distances + this->Count) - this->Distances);
    double distance = this->Distances[first];
    Vector3 normal = this->Normals[first];
    for (int i = 0; i < Steps; ++i)
    {
      const double length = Length(normal);
      const double scale = length > 0.0 ? this->Radius / length : 0.0;
      int best = 0;
      double slope = 1e300;
      for (int other = 0; other < this->Count; ++other)
      {
        const double at = this->Distances[other] + scale * Dot(this->Normals[other], normal);
        if (at < slope)
        {
          slope = at;
          best = other;
        }
      }
      if (!(slope < distance + this->Radius * length - 1e-3 * this->Radius))
      {
        break;
      }
      this->Mix(this->Distances[best], this->Normals[best], distance, normal);
    }
    return distance + this->Radius * Length(normal);
  }

private:
  // Goes to the least on the way to another.
  void Mix(double other, const Vector3& toward, double& distance, Vector3& normal) const
  {
    const Vector3 way = toward - normal;
    const auto at = [&](double part)
    { return part * (other - distance) + this->Radius * Length(normal + part * way); };
    double low = 0.0;
    double high = 1.0;
    for (int i = 0; i < 5; ++i)
    {
      const double third = (high - low) / 3.0;
      (at(low + third) < at(high - third) ? high : low) =
        at(low + third) < at(high - third) ? high - third : low + third;
    }
    const double part = 0.5 * (low + high);
    distance += part * (other - distance);
    normal = normal + part * way;
  }

  static constexpr int MostSpheres = 24;
  static constexpr int Most = MostSpheres + 8; // and planes
  static constexpr int Steps = 8;

  double Radius;
  int Count = 0;
  double Distances[Most];
  Vector3 Normals[Most];
};
}

#endif
