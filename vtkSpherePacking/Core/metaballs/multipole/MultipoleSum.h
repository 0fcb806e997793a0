// SPDX-License-Identifier: BSD-3-Clause
#ifndef MultipoleSum_h
#define MultipoleSum_h

#include "metaballs/field/BlockSum.h"
#include "metaballs/multipole/ClusterQueues.h"
#include "base/LocalVector.h"
#include "metaballs/multipole/TruncationError.h"

#include <memory>

namespace spherepacking
{
inline namespace SPHEREPACKING_ISA
{
/// Sums the field of an inverse kernel over parts of a grid, through the tree of charges.
///
/// A block of the grid and the nodes of the tree that are far enough from it for the wanted error
/// meet in an expansion about the block's middle, which is handed down to the block's halves. Nodes
/// that are too near are opened, or left to the halves, whichever is the larger; what is left for
/// the smallest blocks is summed charge by charge.
template <int Power>
class FieldSummer
{
public:
  explicit FieldSummer(const FieldScene& scene)
    : Scene(scene)
    , Kept(scene.Moments.Kept)
    , Sum(new BlockSum<InverseBlob<Power>>)
  {
  }

  void Run(const FieldBlock& block) { this->Visit(block, { 0 }, nullptr); }

private:
  using Nodes = LocalVector<std::int32_t>;

  // Of charges and places, before a block is halved; each pair takes a fraction of a nanosecond.
  static constexpr std::int64_t MostPairs = 2000000;
  static constexpr int LeastPlaces = 8;

  void Visit(const FieldBlock& block, const Nodes& nodes, const LocalExpansion* above)
  {
    LocalExpansion local;
    const double radius = this->BallOf(block, local.Center);
    // Of a single place no derivatives above the first matter: they vanish in this unit.
    local.Unit = radius > 0.0 ? radius : 1e-20;
    ClusterQueues<Power> queues(this->Scene, local.Unit);
    Nodes near;
    this->Open = nodes;
    this->Sort(local.Center, radius, radius, queues, near);
    const bool last = this->IsLast(block, near);
    if (last)
    {
      // All the way to the leaves.
      this->Open.swap(near);
      near.clear();
      this->Sort(local.Center, radius, -1.0, queues, near);
    }
    queues.AddTo(local);
    if (above)
    {
      ShiftLocal(this->Kept, this->Scene.Moments.All, *above, local);
    }
    if (last)
    {
      this->Write(block, local, near);
      return;
    }
    FieldBlock halves[2] = { block, block };
    this->Halve(block, halves);
    for (const FieldBlock& half : halves)
    {
      this->Visit(half, near, &local);
    }
  }

  bool IsLast(const FieldBlock& block, const Nodes& near) const
  {
    if (near.empty())
    {
      return true;
    }
    std::int64_t charges = 0;
    for (const std::int32_t node : near)
    {
      charges += this->Scene.Tree.Nodes[node].Count;
    }
    const int places = block.Places();
    return FitsBlockSum(block) && (charges * places <= MostPairs || places <= LeastPlaces);
  }

  double BallOf(const FieldBlock& block, double (&center)[3]) const
  {
    double square = 0.0;
    for (int axis = 0; axis < 3; ++axis)
    {
      const double low = this->Scene.Grid.At(axis, block.First[axis]);
      const double high = this->Scene.Grid.At(axis, block.First[axis] + block.Count[axis] - 1);
      center[axis] = 0.5 * (low + high);
      square += 0.25 * (high - low) * (high - low);
    }
    return std::sqrt(square);
  }

  // Halves along the side that is longest in space. Rows along x that have become as short as is
  // summed at once are cut only where they are much longer than the other sides.
  void Halve(const FieldBlock& block, FieldBlock (&halves)[2]) const
  {
    int longest = 0;
    double most = -1.0;
    for (int axis = 0; axis < 3; ++axis)
    {
      const bool row = axis == 0 && block.Count[0] <= MostBlockWidth;
      const double length =
        (block.Count[axis] - 1) * this->Scene.Grid.Spacing[axis] * (row ? 0.25 : 1.0);
      if (block.Count[axis] > 1 && length >= most)
      {
        most = length;
        longest = axis;
      }
    }
    const int count = block.Count[longest];
    const int first = count > MostBlockWidth
      ? (count / 2 + MostBlockWidth - 1) / MostBlockWidth * MostBlockWidth
      : (count + 1) / 2;
    halves[0].Count[longest] = first;
    halves[1].First[longest] += first;
    halves[1].Count[longest] = count - first;
  }

  // Queues the nodes of `Open` that are far enough from the ball of a block. Others are opened if
  // their own radius is above `openAbove` and they are no leaves; the rest is near.
  void Sort(const double (&center)[3], double radius, double openAbove,
    ClusterQueues<Power>& queues, Nodes& near)
  {
    while (!this->Open.empty())
    {
      const std::int32_t at = this->Open.back();
      this->Open.pop_back();
      const ChargeNode& node = this->Scene.Tree.Nodes[at];
      double away[3];
      double square = 0.0;
      for (int axis = 0; axis < 3; ++axis)
      {
        away[axis] = center[axis] - node.Center[axis];
        square += away[axis] * away[axis];
      }
      const double distance = std::sqrt(square);
      // The kernel has to be the same at all these distances.
      if (distance - radius - node.Radius > InverseBlob<Power>::Core * node.MostRadius)
      {
        const double inverse = 1.0 / distance;
        const Separation separation{ radius * inverse, node.Radius * inverse,
          node.MeanRadius * inverse };
        const int order = OrderFor<Power>(separation, this->Scene.Error, this->Kept.Order);
        if (order <= this->Kept.Order)
        {
          queues.Add(at, away, inverse, order);
          continue;
        }
      }
      if (node.Child >= 0 && node.Radius > openAbove)
      {
        this->Open.push_back(node.Child);
        this->Open.push_back(node.Child + 1);
      }
      else
      {
        near.push_back(at);
      }
    }
  }

  void Write(const FieldBlock& block, const LocalExpansion& local, const Nodes& near)
  {
    const FieldGrid& grid = this->Scene.Grid;
    const MultiIndex& all = this->Scene.Moments.All;
    const WholeExpansion whole = WholeOf(this->Kept, local, all);
    this->WriteLocal(block, local.Center, whole, grid.Field, 1);
    for (int axis = 0; grid.Gradient && axis < 3; ++axis)
    {
      this->WriteLocal(
        block, local.Center, DerivativeOf(all, whole, axis), grid.Gradient + axis, 3);
    }
    if (!near.empty())
    {
      this->Sum->Begin(grid, block, this->Scene.Estimate);
      for (const std::int32_t at : near)
      {
        const ChargeNode& node = this->Scene.Tree.Nodes[at];
        this->Sum->Add(
          this->Scene.Tree.Charges.data() + node.First, node.Count, node.Center, node.Radius);
      }
      this->Sum->End();
    }
  }

  void WriteLocal(const FieldBlock& block, const double (&center)[3], const WholeExpansion& whole,
    float* values, int stride) const
  {
    const FieldGrid& grid = this->Scene.Grid;
    LocalGrid places;
    for (int axis = 0; axis < 3; ++axis)
    {
      places.First[axis] = grid.At(axis, block.First[axis]) - center[axis];
      places.Step[axis] = grid.Spacing[axis];
      places.Count[axis] = block.Count[axis];
    }
    ForEachLocalValue(this->Scene.Moments.All, whole, places,
      [&](int x, int y, int z, const Float8& value)
      {
        float* to =
          values + stride * grid.Place(block.First[0] + x, block.First[1] + y, block.First[2] + z);
        const int count = std::min(8, block.Count[0] - x);
        for (int i = 0; i < count; ++i)
        {
          to[stride * i] = value[i];
        }
      });
  }

  const FieldScene& Scene;
  const MultiIndex& Kept;
  Nodes Open;
  std::unique_ptr<BlockSum<InverseBlob<Power>>> Sum;
};
}
}

#endif
