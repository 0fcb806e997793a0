// SPDX-License-Identifier: BSD-3-Clause
#ifndef Strongest_h
#define Strongest_h

#include "metaballs/NearSummer.h"

#include <limits>

namespace spherepacking
{
inline namespace SPHEREPACKING_ISA
{
/// Finds the charge that adds most at each place, by branch and bound over the tree.
template <typename Blob>
class StrongestFinder
{
public:
  explicit StrongestFinder(const FieldScene& scene)
    : Scene(scene)
  {
  }

  void Run(const FieldBlock& block)
  {
    ForEachPart(block, [this](const FieldBlock& part) { this->RunPart(part); });
  }

private:
  void RunPart(const FieldBlock& part)
  {
    for (int axis = 0; axis < 3; ++axis)
    {
      this->Low[axis] = this->Scene.Grid.At(axis, part.First[axis]);
      this->High[axis] = this->Scene.Grid.At(axis, part.First[axis] + part.Count[axis] - 1);
    }
    this->Bound();
    this->Collect();
    this->LeaveOutCovered();
    for (int z = 0; z < part.Count[2]; ++z)
    {
      for (int y = 0; y < part.Count[1]; ++y)
      {
        for (int x = 0; x < part.Count[0]; ++x)
        {
          const std::int64_t at[3] = { part.First[0] + x, part.First[1] + y, part.First[2] + z };
          this->Scene.Grid.Strongest[this->Scene.Grid.Place(at[0], at[1], at[2])] = this->At(at);
        }
      }
    }
  }

  // Squares of the distances from a point to the nearest and the farthest point of the part.
  void Distances(const double (&point)[3], double& nearest, double& farthest) const
  {
    nearest = farthest = 0.0;
    for (int axis = 0; axis < 3; ++axis)
    {
      const double below = this->Low[axis] - point[axis];
      const double above = point[axis] - this->High[axis];
      const double near = std::max(std::max(below, above), 0.0);
      const double far = std::max(-below, -above);
      nearest += near * near;
      farthest += far * far;
    }
  }

  double MostOf(const ChargeNode& node) const
  {
    double nearest;
    double farthest;
    this->Distances(node.Center, nearest, farthest);
    const double distance = std::max(0.0, std::sqrt(nearest) - node.Radius);
    // A little less than that, for rounding.
    return Blob::Most(0.999999 * distance, node.MostStrength, node.MostRadius);
  }

  // Sets `Least` to what some charge adds at every place of the part.
  void Bound()
  {
    this->Least = 0.0;
    this->Open.assign(1, 0);
    while (!this->Open.empty())
    {
      const ChargeNode& node = this->Scene.Tree.Nodes[this->Open.back()];
      this->Open.pop_back();
      if (this->MostOf(node) < this->Least)
      {
        continue;
      }
      if (node.Child >= 0)
      {
        // The stronger first, which raises the bound.
        const std::int32_t child = node.Child;
        const bool second = this->MostOf(this->Scene.Tree.Nodes[child + 1]) >
          this->MostOf(this->Scene.Tree.Nodes[child]);
        this->Open.push_back(child + !second);
        this->Open.push_back(child + second);
        continue;
      }
      for (std::int32_t i = node.First; i < node.First + node.Count; ++i)
      {
        const Charge& charge = this->Scene.Tree.Charges[i];
        double nearest;
        double farthest;
        this->Distances(charge.X, nearest, farthest);
        this->Least = std::max(this->Least,
          Blob::Value(farthest, static_cast<double>(charge.Strength), Blob::Shape(charge.Radius)));
      }
    }
    this->Least *= 0.999999;
  }

  // Puts those that may be the strongest somewhere into `Some`.
  void Collect()
  {
    this->Some.clear();
    this->Open.assign(1, 0);
    while (!this->Open.empty())
    {
      const ChargeNode& node = this->Scene.Tree.Nodes[this->Open.back()];
      this->Open.pop_back();
      if (this->MostOf(node) < this->Least)
      {
        continue;
      }
      if (node.Child >= 0)
      {
        this->Open.push_back(node.Child);
        this->Open.push_back(node.Child + 1);
        continue;
      }
      for (std::int32_t i = node.First; i < node.First + node.Count; ++i)
      {
        const Charge& charge = this->Scene.Tree.Charges[i];
        double nearest;
        double farthest;
        this->Distances(charge.X, nearest, farthest);
        const double most =
          Blob::Value(nearest, static_cast<double>(charge.Strength), Blob::Shape(charge.Radius));
        if (most > 0.0 && most >= this->Least)
        {
          this->Some.push_back(&charge);
        }
      }
    }
  }

  // Of charges at one place, those that another one surpasses everywhere.
  void LeaveOutCovered()
  {
    const auto before = [](const Charge* one, const Charge* other)
    {
      for (int axis = 0; axis < 3; ++axis)
      {
        if (one->X[axis] != other->X[axis])
        {
          return one->X[axis] < other->X[axis];
        }
      }
      if (one->Strength != other->Strength)
      {
        return one->Strength > other->Strength;
      }
      return one->Radius != other->Radius ? one->Radius > other->Radius : one->Id < other->Id;
    };
    std::sort(this->Some.begin(), this->Some.end(), before);
    std::size_t kept = 0;
    float radius = 0.0f;
    for (std::size_t i = 0; i < this->Some.size(); ++i)
    {
      const Charge* charge = this->Some[i];
      const bool first = i == 0 || !std::equal(charge->X, charge->X + 3, this->Some[i - 1]->X);
      if (first || charge->Radius > radius)
      {
        radius = charge->Radius;
        this->Some[kept++] = charge;
      }
    }
    this->Some.resize(kept);
  }

  std::int64_t At(const std::int64_t (&place)[3]) const
  {
    double best = 0.0;
    std::int64_t id = -1;
    for (const Charge* charge : this->Some)
    {
      double square = 0.0;
      for (int axis = 0; axis < 3; ++axis)
      {
        const double away = this->Scene.Grid.At(axis, place[axis]) - charge->X[axis];
        square += away * away;
      }
      const double value =
        Blob::Value(square, static_cast<double>(charge->Strength), Blob::Shape(charge->Radius));
      if (value > best || (value == best && value > 0.0 && charge->Id < id))
      {
        best = value;
        id = charge->Id;
      }
    }
    return id;
  }

  const FieldScene& Scene;
  double Low[3];
  double High[3];
  double Least = 0.0;
  LocalVector<std::int32_t> Open;
  LocalVector<const Charge*> Some;
};
}
}

#endif
