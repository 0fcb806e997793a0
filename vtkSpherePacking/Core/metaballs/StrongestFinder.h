// SPDX-License-Identifier: BSD-3-Clause
#ifndef StrongestFinder_h
#define StrongestFinder_h

#include "metaballs/DirectSum.h"

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
  using Charges = LocalVector<const Charge*>;

  void RunPart(const FieldBlock& part)
  {
    this->SetSides(part);
    this->Bound();
    if (!this->Collect(part.Places() > 1))
    {
      FieldBlock halves[2];
      CutInHalves(part, halves);
      this->RunPart(halves[0]);
      this->RunPart(halves[1]);
      return;
    }
    this->Search(part, 0);
  }

  static void CutInHalves(const FieldBlock& part, FieldBlock (&halves)[2])
  {
    const int* count = part.Count;
    const int axis = count[2] >= count[1] && count[2] >= count[0] ? 2 : count[1] >= count[0];
    halves[0] = halves[1] = part;
    halves[0].Count[axis] = count[axis] / 2;
    halves[1].First[axis] += halves[0].Count[axis];
    halves[1].Count[axis] -= halves[0].Count[axis];
  }

  void SetSides(const FieldBlock& part)
  {
    for (int axis = 0; axis < 3; ++axis)
    {
      this->Low[axis] = this->Scene.Grid.At(axis, part.First[axis]);
      this->High[axis] = this->Scene.Grid.At(axis, part.First[axis] + part.Count[axis] - 1);
    }
  }

  // Looks at the charges that are left, or first leaves out those that are surpassed everywhere in
  // either half.
  void Search(const FieldBlock& part, int depth)
  {
    constexpr std::size_t few = 4;
    if (part.Places() == 1 || this->Some[depth].size() <= few)
    {
      this->Write(part, this->Some[depth]);
      return;
    }
    FieldBlock halves[2];
    CutInHalves(part, halves);
    for (const FieldBlock& half : halves)
    {
      this->SetSides(half);
      this->LeaveOutSurpassed(this->Some[depth], this->Some[depth + 1]);
      this->Search(half, depth + 1);
    }
  }

  void Write(const FieldBlock& part, const Charges& charges)
  {
    const FieldGrid& grid = this->Scene.Grid;
    for (int z = 0; z < part.Count[2]; ++z)
    {
      for (int y = 0; y < part.Count[1]; ++y)
      {
        for (int x = 0; x < part.Count[0]; ++x)
        {
          const std::int64_t at[3] = { part.First[0] + x, part.First[1] + y, part.First[2] + z };
          grid.Strongest[grid.Place(at[0], at[1], at[2])] = this->At(charges, at);
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
    return Blob::MostRank(0.999999 * distance, node.MostStrength, node.MostRadius);
  }

  // Ranks of what a charge adds in the part, at least and at most.
  void Range(const Charge& charge, double& least, double& most) const
  {
    double nearest;
    double farthest;
    this->Distances(charge.X, nearest, farthest);
    const auto strength = static_cast<double>(charge.Strength);
    least = Blob::Rank(farthest, strength, Blob::Shape(charge.Radius));
    most = Blob::Rank(nearest, strength, Blob::Shape(charge.Radius));
  }

  void LeaveOutSurpassed(const Charges& from, Charges& to)
  {
    this->Mosts.clear();
    this->Least = Blob::LeastRank;
    for (const Charge* charge : from)
    {
      double least;
      double most;
      this->Range(*charge, least, most);
      this->Least = std::max(this->Least, least);
      this->Mosts.push_back(most);
    }
    this->LowerLeast();
    to.clear();
    for (std::size_t i = 0; i < from.size(); ++i)
    {
      if (this->MayWin(this->Mosts[i]))
      {
        to.push_back(from[i]);
      }
    }
  }

  bool MayWin(double rank) const { return rank > Blob::LeastRank && rank >= this->Least; }

  void LowerLeast() { this->Least = std::max(Blob::Below(this->Least), Blob::LeastRank); }

  // Sets `Least`.
  void Bound()
  {
    this->Least = Blob::LeastRank;
    this->Open.assign(1, 0);
    while (!this->Open.empty())
    {
      const ChargeNode& node = this->Scene.Tree.Nodes[this->Open.back()];
      this->Open.pop_back();
      if (!this->MayWin(this->MostOf(node)))
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
        double least;
        double most;
        this->Range(charge, least, most);
        this->Least = std::max(this->Least, least);
      }
    }
    this->LowerLeast();
  }

  // Puts those that may be the strongest somewhere into the first of `Some`; false if that ended
  // because there are too many.
  bool Collect(bool mayEnd)
  {
    this->Some[0].clear();
    this->Open.assign(1, 0);
    while (!this->Open.empty())
    {
      const ChargeNode& node = this->Scene.Tree.Nodes[this->Open.back()];
      this->Open.pop_back();
      if (!this->MayWin(this->MostOf(node)))
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
        double least;
        double greatest;
        this->Range(charge, least, greatest);
        if (this->MayWin(greatest))
        {
          this->Some[0].push_back(&charge);
        }
      }
      if (mayEnd && this->Some[0].size() > Many)
      {
        this->LeaveOutCovered();
        if (this->Some[0].size() > Many / 2)
        {
          return false;
        }
      }
    }
    this->LeaveOutCovered();
    return true;
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
    Charges& some = this->Some[0];
    std::sort(some.begin(), some.end(), before);
    std::size_t kept = 0;
    float radius = 0.0f;
    for (std::size_t i = 0; i < some.size(); ++i)
    {
      const Charge* charge = some[i];
      const bool first = i == 0 || !std::equal(charge->X, charge->X + 3, some[i - 1]->X);
      if (first || charge->Radius > radius)
      {
        radius = charge->Radius;
        some[kept++] = charge;
      }
    }
    some.resize(kept);
  }

  std::int64_t At(const Charges& charges, const std::int64_t (&place)[3]) const
  {
    double best = 0.0;
    std::int64_t id = -1;
    for (const Charge* charge : charges)
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

  static constexpr std::size_t Many = 2000;
  static constexpr int MostDepth = 9; // of a part of 8 x 8 x 8 places

  const FieldScene& Scene;
  double Low[3];
  double High[3];
  double Least = 0.0; ///< rank of what some charge adds at every place of the part
  LocalVector<std::int32_t> Open;
  LocalVector<double> Mosts;
  Charges Some[MostDepth + 1]; ///< that may be the strongest somewhere in the part, by its depth
};
}
}

#endif
