// SPDX-License-Identifier: BSD-3-Clause
#ifndef StrongestFinder_h
#define StrongestFinder_h

#include "base/LocalVector.h"
#include "metaballs/DirectSum.h"

#include <algorithm>
#include <cmath>

namespace spherepacking
{
inline namespace SPHEREPACKING_ISA
{
/// Finds the charge that adds most at each point of a grid, by branch and bound.
///
/// In a box of points each charge has a least and a greatest rank (see Blobs.h). The largest of the
/// least ranks is a lower bound for the winner at every point of the box; charges whose greatest
/// rank is below it, and nodes of the tree for which that can be shown of all their charges, cannot
/// win. What remains are the candidates; halving the box raises the bound, until there are few.
///
/// Source: Land and Doig, "An automatic method of solving discrete programming problems" (1960),
/// for branch and bound.
template <typename Blob>
class StrongestFinder
{
public:
  /// Both have to outlive this; the tree is not empty.
  StrongestFinder(const FieldGrid& grid, const ChargeTree& tree)
    : Grid(grid)
    , Tree(tree)
  {
  }

  /// Sets the ids at the points of a block.
  void Run(const FieldBlock& block)
  {
    ForEachPart(block, [this](const FieldBlock& part) { this->RunPart(part); });
  }

private:
  using ChargeList = LocalVector<const Charge*>;

  static constexpr std::size_t MaxCandidates = 2000;
  static constexpr std::size_t FewCandidates = 4; // which are compared point by point
  static constexpr int MaxDepth = 9;              // of a part of 8 x 8 x 8 points

  void RunPart(const FieldBlock& part)
  {
    this->SetBox(part);
    this->FindLowerBound();
    if (!this->CollectCandidates(part.Points() > 1))
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

  void SetBox(const FieldBlock& part)
  {
    for (int axis = 0; axis < 3; ++axis)
    {
      this->Low[axis] = this->Grid.At(axis, part.First[axis]);
      this->High[axis] = this->Grid.At(axis, part.First[axis] + part.Count[axis] - 1);
    }
  }

  // Compares the candidates at each point if they or the points are few, else prunes them for
  // either half of the part.
  void Search(const FieldBlock& part, int depth)
  {
    if (part.Points() == 1 || this->Candidates[depth].size() <= FewCandidates)
    {
      this->Write(part, this->Candidates[depth]);
      return;
    }
    FieldBlock halves[2];
    CutInHalves(part, halves);
    for (const FieldBlock& half : halves)
    {
      this->SetBox(half);
      this->Prune(this->Candidates[depth], this->Candidates[depth + 1]);
      this->Search(half, depth + 1);
    }
  }

  void Write(const FieldBlock& part, const ChargeList& candidates)
  {
    for (int z = 0; z < part.Count[2]; ++z)
    {
      for (int y = 0; y < part.Count[1]; ++y)
      {
        for (int x = 0; x < part.Count[0]; ++x)
        {
          const std::int64_t at[3] = { part.First[0] + x, part.First[1] + y, part.First[2] + z };
          this->Grid.Strongest[this->Grid.Index(at[0], at[1], at[2])] =
            this->StrongestAt(candidates, at);
        }
      }
    }
  }

  // Squared distances from a point to the nearest and to the farthest point of the box.
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

  // No charge of the node has a greater rank in the box.
  double UpperBoundOf(const ChargeNode& node) const
  {
    double nearest;
    double farthest;
    this->Distances(node.Center, nearest, farthest);
    const double distance = std::max(0.0, std::sqrt(nearest) - node.Radius);
    return Blob::MaxRank(0.999999 * distance, node.MaxStrength, node.MaxRadius);
  }

  // The least and the greatest rank of a charge in the box.
  void RankRange(const Charge& charge, double& low, double& high) const
  {
    double nearest;
    double farthest;
    this->Distances(charge.Position, nearest, farthest);
    const auto strength = static_cast<double>(charge.Strength);
    low = Blob::Rank(farthest, strength, Blob::Shape(charge.Radius));
    high = Blob::Rank(nearest, strength, Blob::Shape(charge.Radius));
  }

  bool MayWin(double upperBound) const
  {
    return upperBound > Blob::ZeroRank && upperBound >= this->LowerBound;
  }

  // Allows for rounding.
  void RelaxLowerBound()
  {
    this->LowerBound = std::max(Blob::Relaxed(this->LowerBound), Blob::ZeroRank);
  }

  void Prune(const ChargeList& from, ChargeList& to)
  {
    this->UpperBounds.clear();
    this->LowerBound = Blob::ZeroRank;
    for (const Charge* charge : from)
    {
      double low;
      double high;
      this->RankRange(*charge, low, high);
      this->LowerBound = std::max(this->LowerBound, low);
      this->UpperBounds.push_back(high);
    }
    this->RelaxLowerBound();
    to.clear();
    for (std::size_t i = 0; i < from.size(); ++i)
    {
      if (this->MayWin(this->UpperBounds[i]))
      {
        to.push_back(from[i]);
      }
    }
  }

  void FindLowerBound()
  {
    this->LowerBound = Blob::ZeroRank;
    this->Open.assign(1, 0);
    while (!this->Open.empty())
    {
      const ChargeNode& node = this->Tree.Nodes[this->Open.back()];
      this->Open.pop_back();
      if (!this->MayWin(this->UpperBoundOf(node)))
      {
        continue;
      }
      if (node.Child >= 0)
      {
        // The child with the greater upper bound goes first, as it is likely to raise the bound.
        const std::int32_t child = node.Child;
        const bool second = this->UpperBoundOf(this->Tree.Nodes[child + 1]) >
          this->UpperBoundOf(this->Tree.Nodes[child]);
        this->Open.push_back(child + !second);
        this->Open.push_back(child + second);
        continue;
      }
      for (std::int32_t i = node.First; i < node.First + node.Count; ++i)
      {
        double low;
        double high;
        this->RankRange(this->Tree.Charges[i], low, high);
        this->LowerBound = std::max(this->LowerBound, low);
      }
    }
    this->RelaxLowerBound();
  }

  // Sets the candidates of depth 0; false if it gave up because there are too many.
  bool CollectCandidates(bool mayGiveUp)
  {
    ChargeList& candidates = this->Candidates[0];
    candidates.clear();
    this->Open.assign(1, 0);
    while (!this->Open.empty())
    {
      const ChargeNode& node = this->Tree.Nodes[this->Open.back()];
      this->Open.pop_back();
      if (!this->MayWin(this->UpperBoundOf(node)))
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
        const Charge& charge = this->Tree.Charges[i];
        double low;
        double high;
        this->RankRange(charge, low, high);
        if (this->MayWin(high))
        {
          candidates.push_back(&charge);
        }
      }
      if (mayGiveUp && candidates.size() > MaxCandidates)
      {
        this->PruneCoincident();
        if (candidates.size() > MaxCandidates / 2)
        {
          return false;
        }
      }
    }
    this->PruneCoincident();
    return true;
  }

  // By position; of coincident charges a later one can only win if its radius is larger.
  struct CoincidentOrder
  {
    bool operator()(const Charge* one, const Charge* other) const
    {
      for (int axis = 0; axis < 3; ++axis)
      {
        if (one->Position[axis] != other->Position[axis])
        {
          return one->Position[axis] < other->Position[axis];
        }
      }
      if (one->Strength != other->Strength)
      {
        return one->Strength > other->Strength;
      }
      return one->Radius != other->Radius ? one->Radius > other->Radius : one->Id < other->Id;
    }
  };

  // Removes candidates that another one at the same position surpasses, or equals, everywhere. By
  // their bounds alone, thousands of concentric spheres would remain in all but the smallest boxes.
  void PruneCoincident()
  {
    ChargeList& candidates = this->Candidates[0];
    std::sort(candidates.begin(), candidates.end(), CoincidentOrder());
    std::size_t count = 0;
    float radius = 0.0f;
    for (std::size_t i = 0; i < candidates.size(); ++i)
    {
      const Charge* charge = candidates[i];
      const bool first =
        i == 0 || !std::equal(charge->Position, charge->Position + 3, candidates[i - 1]->Position);
      if (first || charge->Radius > radius)
      {
        radius = charge->Radius;
        candidates[count++] = charge;
      }
    }
    candidates.resize(count);
  }

  // The id of the charge that adds most at a point; of equals the lowest.
  std::int64_t StrongestAt(const ChargeList& candidates, const std::int64_t (&point)[3]) const
  {
    double best = 0.0;
    std::int64_t id = -1;
    for (const Charge* charge : candidates)
    {
      double square = 0.0;
      for (int axis = 0; axis < 3; ++axis)
      {
        const double distance = this->Grid.At(axis, point[axis]) - charge->Position[axis];
        square += distance * distance;
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

  const FieldGrid& Grid;
  const ChargeTree& Tree;
  double Low[3]; // of the box
  double High[3];
  double LowerBound = 0.0;
  LocalVector<std::int32_t> Open; // nodes to be tested
  LocalVector<double> UpperBounds;
  ChargeList Candidates[MaxDepth + 1]; // by how often the part has been halved
};
}
}

#endif
