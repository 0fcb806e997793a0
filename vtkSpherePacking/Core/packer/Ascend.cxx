// SPDX-License-Identifier: BSD-3-Clause
#include "packer/Ascend.h"

#include <algorithm>

namespace spherepacking
{
namespace
{
constexpr int MaximumSteps = 120;
constexpr double FinalStep = 1e-7;         // over the clearance
constexpr double MaximumGain = 2.0;        // that is still expected, over the step
constexpr double SufficientIncrease = 0.1; // of what the gradient promises, as Armijo's condition
constexpr double Stationary = 0.03;        // length of a gradient that counts as none

// Approximates the shortest vector in the convex hull of unit vectors: Gilbert's iteration, which
// moves towards the vector that is farthest back.
Vector3 ShortestInHull(const std::vector<Vector3>& vectors)
{
  Vector3 shortest = vectors.front();
  for (int i = 0; i < 60; ++i)
  {
    const double square = Dot(shortest, shortest);
    double smallest = square;
    const Vector3* farthest = nullptr;
    for (const Vector3& vector : vectors)
    {
      const double along = Dot(vector, shortest);
      if (along < smallest)
      {
        smallest = along;
        farthest = &vector;
      }
    }
    if (!farthest || square < Stationary * Stationary || square - smallest < 1e-3 * square)
    {
      break;
    }
    const Vector3 edge = *farthest - shortest;
    const double weight = std::min(1.0, (square - smallest) / Dot(edge, edge));
    shortest = shortest + weight * edge;
  }
  return shortest;
}

class Climber
{
public:
  Climber(const ClearanceTree& tree, const Vector3& start)
    : Tree(tree)
    , Point(start)
  {
    this->Here = this->Sample(start);
  }

  PackedSphere Run(double step, double required)
  {
    for (int i = 0; i < MaximumSteps && step > FinalStep * this->Here.Clearance; ++i)
    {
      if (this->Here.Clearance + MaximumGain * step < required)
      {
        break;
      }
      const Vector3 ascent = this->SteepestAscent(step);
      const double length = Length(ascent);
      if (length < Stationary)
      {
        step *= 0.25;
        continue;
      }
      const Vector3 next = this->Point + (step / length) * ascent;
      const ClearanceTree::Sample there = this->Sample(next);
      if (there.Clearance > this->Here.Clearance + SufficientIncrease * step * length)
      {
        this->Point = next;
        this->Here = there;
      }
      else
      {
        step *= 0.5;
      }
    }
    return { this->Point, this->Here.Clearance };
  }

private:
  struct Plane
  {
    Vector3 Point;
    Vector3 Normal; // away from the surface
  };

  ClearanceTree::Sample Sample(const Vector3& point)
  {
    const ClearanceTree::Sample sample = this->Tree.SampleAt(point, this->Guess);
    if (sample.BySurface && sample.Clearance > 0.0)
    {
      const Vector3 normal = (1.0 / sample.Clearance) * (point - sample.Nearest.Point);
      if (this->Planes.size() == MaximumPlanes)
      {
        this->Planes.erase(this->Planes.begin());
      }
      this->Planes.push_back({ sample.Nearest.Point, normal });
      this->Guess = sample.Nearest.Triangle;
    }
    return sample;
  }

  Vector3 SteepestAscent(double step)
  {
    const double reach = this->Here.Clearance + step;
    this->Gradients.clear();
    for (const std::int32_t i : this->Tree[this->Here.Leaf].Near)
    {
      const PackedSphere& sphere = this->Tree.Spheres()[i];
      const Vector3 offset = this->Point - sphere.Center;
      const double length = Length(offset);
      if (length - sphere.Radius <= reach)
      {
        this->Gradients.push_back((1.0 / length) * offset);
      }
    }
    for (const Plane& plane : this->Planes)
    {
      if (Dot(this->Point - plane.Point, plane.Normal) <= reach)
      {
        this->Gradients.push_back(plane.Normal);
      }
    }
    return this->Gradients.empty() ? Vector3{} : ShortestInHull(this->Gradients);
  }

  static constexpr std::size_t MaximumPlanes = 24;

  const ClearanceTree& Tree;
  Vector3 Point;
  ClearanceTree::Sample Here;
  std::int32_t Guess = -1;
  std::vector<Plane> Planes;
  std::vector<Vector3> Gradients;
};
}

//------------------------------------------------------------------------------
PackedSphere Ascend(const ClearanceTree& tree, const Vector3& start, double step, double required)
{
  return Climber(tree, start).Run(step, required);
}
}
