// SPDX-License-Identifier: BSD-3-Clause
#include "packer/Ascend.h"

#include <algorithm>

namespace spherepacking
{
namespace
{
constexpr int MostSteps = 120;
constexpr double Finest = 1e-7;     // step over clearance at the end
constexpr double Reach = 2.0;       // what may still be gained, over the step
constexpr double Stationary = 0.03; // length of a gradient that is as good as none

// The shortest vector in the convex hull of unit vectors, nearly.
Vector3 ShortestIn(const std::vector<Vector3>& vectors)
{
  Vector3 shortest = vectors.front();
  for (int i = 0; i < 60; ++i)
  {
    const double square = Dot(shortest, shortest);
    double least = square;
    const Vector3* farthest = nullptr;
    for (const Vector3& vector : vectors)
    {
      const double along = Dot(vector, shortest);
      if (along < least)
      {
        least = along;
        farthest = &vector;
      }
    }
    if (!farthest || square < Stationary * Stationary || square - least < 1e-3 * square)
    {
      break;
    }
    const Vector3 way = *farthest - shortest;
    const double part = std::min(1.0, (square - least) / Dot(way, way));
    shortest = shortest + part * way;
  }
  return shortest;
}

class Climber
{
public:
  Climber(const ClearanceTree& tree, const Vector3& start)
    : Tree(tree)
    , Place(start)
  {
    this->Here = this->Look(start);
  }

  PackedSphere Run(double step, double enough)
  {
    for (int i = 0; i < MostSteps && step > Finest * this->Here.Clearance; ++i)
    {
      if (this->Here.Clearance + Reach * step < enough)
      {
        break;
      }
      const Vector3 way = this->Way(step);
      const double length = Length(way);
      if (length < Stationary)
      {
        step *= 0.25;
        continue;
      }
      const Vector3 next = this->Place + (step / length) * way;
      const ClearanceTree::Found there = this->Look(next);
      if (there.Clearance > this->Here.Clearance + 0.1 * step * length)
      {
        this->Place = next;
        this->Here = there;
      }
      else
      {
        step *= 0.5;
      }
    }
    return { this->Place, this->Here.Clearance };
  }

private:
  struct Plane
  {
    Vector3 Point;
    Vector3 Normal; // away from the surface
  };

  ClearanceTree::Found Look(const Vector3& place)
  {
    const ClearanceTree::Found found = this->Tree.At(place, this->Guess);
    if (found.BySurface && found.Clearance > 0.0)
    {
      const Vector3 normal = (1.0 / found.Clearance) * (place - found.Nearest.Point);
      if (this->Planes.size() == MostPlanes)
      {
        this->Planes.erase(this->Planes.begin());
      }
      this->Planes.push_back({ found.Nearest.Point, normal });
      this->Guess = found.Nearest.Triangle;
    }
    return found;
  }

  Vector3 Way(double step)
  {
    const double most = this->Here.Clearance + step;
    this->Gradients.clear();
    for (const std::int32_t i : this->Tree[this->Here.Leaf].Near)
    {
      const PackedSphere& sphere = this->Tree.Spheres()[i];
      const Vector3 away = this->Place - sphere.Center;
      const double length = Length(away);
      if (length - sphere.Radius <= most)
      {
        this->Gradients.push_back((1.0 / length) * away);
      }
    }
    for (const Plane& plane : this->Planes)
    {
      if (Dot(this->Place - plane.Point, plane.Normal) <= most)
      {
        this->Gradients.push_back(plane.Normal);
      }
    }
    return this->Gradients.empty() ? Vector3{} : ShortestIn(this->Gradients);
  }

  static constexpr std::size_t MostPlanes = 24;

  const ClearanceTree& Tree;
  Vector3 Place;
  ClearanceTree::Found Here;
  std::int32_t Guess = -1;
  std::vector<Plane> Planes;
  std::vector<Vector3> Gradients;
};
}

//------------------------------------------------------------------------------
PackedSphere Ascend(const ClearanceTree& tree, const Vector3& start, double step, double enough)
{
  return Climber(tree, start).Run(step, enough);
}
}
