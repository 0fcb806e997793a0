// SPDX-License-Identifier: BSD-3-Clause
#ifndef ClearanceBound_h
#define ClearanceBound_h

#include "base/Vector3.h"

#include <algorithm>

namespace spherepacking
{
/// An upper bound of the smallest of several distances, over all points of a ball.
///
/// At an offset u from the ball's centre, the distance to a sphere whose centre is at -a is at most
/// d + n.u + |u|^2 / (2 |a|), where n = a / |a| and d is the distance from the ball's centre, as
/// the square root is concave. The smallest of several distances is at most any mean of them. So in
/// a ball of radius h, for weights w_i >= 0 of sum 1, it is at most
///
///   sum w_i d_i + h |sum w_i n_i| + sum w_i h^2 / (2 |a_i|).
///
/// The weights are optimised step by step. Where spheres are all around, the n_i cancel and the
/// bound is hardly above the distance at the centre.
/// Source: Frank and Wolfe, "An algorithm for quadratic programming" (1956).
class ClearanceBound
{
public:
  explicit ClearanceBound(double radius)
    : Radius(radius)
  {
  }

  /// Adds a sphere, by the vector from its centre to that of the ball and the vector's length. Once
  /// there is no room it does nothing, which leaves the bound valid.
  void Add(const Vector3& offset, double length, double sphereRadius)
  {
    if (this->Count == MaximumSpheres || !(length > 0.0))
    {
      return;
    }
    this->Normals[this->Count] = (1.0 / length) * offset;
    this->Distances[this->Count] =
      length - sphereRadius + this->Radius * this->Radius / (2.0 * length);
    ++this->Count;
  }

  /// Adds a plane, by its unit normal and the signed distance of the ball's centre from it. Up
  /// to 8.
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
      this->SearchLine(this->Distances[best], this->Normals[best], distance, normal);
    }
    return distance + this->Radius * Length(normal);
  }

private:
  // Moves weight to one of the distances, as much as gives the lowest bound, by a ternary search.
  void SearchLine(
    double otherDistance, const Vector3& otherNormal, double& distance, Vector3& normal) const
  {
    const Vector3 direction = otherNormal - normal;
    const auto at = [&](double weight)
    {
      return weight * (otherDistance - distance) +
        this->Radius * Length(normal + weight * direction);
    };
    double low = 0.0;
    double high = 1.0;
    for (int i = 0; i < 5; ++i)
    {
      const double third = (high - low) / 3.0;
      (at(low + third) < at(high - third) ? high : low) =
        at(low + third) < at(high - third) ? high - third : low + third;
    }
    const double weight = 0.5 * (low + high);
    distance += weight * (otherDistance - distance);
    normal = normal + weight * direction;
  }

  static constexpr int MaximumSpheres = 24;
  static constexpr int MaximumPlanes = 8;
  static constexpr int Capacity = MaximumSpheres + MaximumPlanes;
  static constexpr int Steps = 8;

  double Radius;
  int Count = 0;
  double Distances[Capacity];
  Vector3 Normals[Capacity];
};
}

#endif
