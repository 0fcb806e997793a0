// SPDX-License-Identifier: BSD-3-Clause
/// The fast multipole method.
///
/// The points of a grid and the charges both form trees, blocks of points and clusters of charges,
/// which are traversed together. A cluster that is far enough from a block for the wanted error is
/// translated into a local expansion about the block's middle (M2L), which passes down to the
/// block's halves (L2L). Of a cluster that is too near, the larger of the two is split: the cluster
/// is opened, or the block hands it to its halves. At the smallest blocks the expansion is
/// evaluated (L2P), and what is still near is summed directly (P2P).
///
/// Sources: Greengard and Rokhlin, "A fast algorithm for particle simulations" (1987); Dehnen, "A
/// hierarchical O(N) force calculation algorithm" (2002), for Cartesian expansions and the
/// traversal of both trees.
#ifndef MultipoleSum_h
#define MultipoleSum_h

#include "base/LocalVector.h"
#include "metaballs/field/BlockSum.h"
#include "metaballs/multipole/ClusterQueues.h"
#include "metaballs/multipole/TruncationError.h"

#include <memory>

namespace spherepacking
{
inline namespace SPHEREPACKING_ISA
{
/// Sums the field of an inverse kernel over blocks of a grid.
template <int Power>
class MultipoleSum
{
public:
  /// All of these have to outlive this; the tree is not empty.
  MultipoleSum(const FieldGrid& grid, const ChargeTree& tree, const Multipoles& multipoles)
    : Grid(grid)
    , Tree(tree)
    , Expansions(multipoles)
    , Reduced(multipoles.Moments.Reduced)
    , Full(multipoles.Moments.Full)
    , Sum(new BlockSum<InverseBlob<Power>>)
  {
  }

  /// Sets the grid's arrays at the points of a block.
  void Run(const FieldBlock& block) { this->Visit(block, { 0 }, nullptr); }

private:
  using Nodes = LocalVector<std::int32_t>;

  // The most pairs of a charge in the near field and a point that a block may have, else it is
  // halved; a pair takes a fraction of a nanosecond. Blocks of few points are not halved any more.
  static constexpr std::int64_t MaxPairs = 2000000;
  static constexpr int MinPoints = 8;

  // Sums the field of the clusters `nodes` in a block, and of all others, which are in the local
  // expansion `above` if there are any.
  void Visit(const FieldBlock& block, const Nodes& nodes, const LocalExpansion* above)
  {
    LocalExpansion local;
    const double radius = this->BallOf(block, local.Center);
    // At a single point derivatives above the first do not matter: they vanish in this unit.
    local.Unit = radius > 0.0 ? radius : 1e-20;
    ClusterQueues<Power> queues(this->Tree, this->Expansions, local.Unit);
    Nodes near;
    this->Open = nodes;
    this->QueueFar(local.Center, radius, radius, queues, near);
    const bool last = this->IsLast(block, near);
    if (last)
    {
      // Opens all clusters that are near, down to the leaves.
      this->Open.swap(near);
      near.clear();
      this->QueueFar(local.Center, radius, -1.0, queues, near);
    }
    queues.FlushTo(local);
    if (above)
    {
      ShiftLocal(this->Reduced, this->Full, *above, local);
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
      charges += this->Tree.Nodes[node].Count;
    }
    const int points = block.Points();
    return FitsBlockSum(block) && (charges * points <= MaxPairs || points <= MinPoints);
  }

  // Sets the centre of a block and returns the radius of the ball around its points.
  double BallOf(const FieldBlock& block, double (&center)[3]) const
  {
    double square = 0.0;
    for (int axis = 0; axis < 3; ++axis)
    {
      const double low = this->Grid.At(axis, block.First[axis]);
      const double high = this->Grid.At(axis, block.First[axis] + block.Count[axis] - 1);
      center[axis] = 0.5 * (low + high);
      square += 0.25 * (high - low) * (high - low);
    }
    return std::sqrt(square);
  }

  // Halves along the longest side in space. Rows along x that fit into a vector are cut only where
  // they are much longer than the other sides.
  void Halve(const FieldBlock& block, FieldBlock (&halves)[2]) const
  {
    int longest = 0;
    double longestLength = -1.0;
    for (int axis = 0; axis < 3; ++axis)
    {
      const bool fitsVector = axis == 0 && block.Count[0] <= MaxBlockWidth;
      const double length =
        (block.Count[axis] - 1) * this->Grid.Spacing[axis] * (fitsVector ? 0.25 : 1.0);
      if (block.Count[axis] > 1 && length >= longestLength)
      {
        longestLength = length;
        longest = axis;
      }
    }
    const int count = block.Count[longest];
    const int first = count > MaxBlockWidth
      ? (count / 2 + MaxBlockWidth - 1) / MaxBlockWidth * MaxBlockWidth
      : (count + 1) / 2;
    halves[0].Count[longest] = first;
    halves[1].First[longest] += first;
    halves[1].Count[longest] = count - first;
  }

  // Queues the clusters of `Open` that are far enough from the ball of a block, see
  // TruncationError.h. Others are opened if their radius is above `openAbove` and they are no
  // leaves; the rest is near.
  void QueueFar(const double (&center)[3], double radius, double openAbove,
    ClusterQueues<Power>& queues, Nodes& near)
  {
    while (!this->Open.empty())
    {
      const std::int32_t at = this->Open.back();
      this->Open.pop_back();
      const ChargeNode& node = this->Tree.Nodes[at];
      double direction[3];
      double square = 0.0;
      for (int axis = 0; axis < 3; ++axis)
      {
        direction[axis] = center[axis] - node.Center[axis];
        square += direction[axis] * direction[axis];
      }
      const double distance = std::sqrt(square);
      // The expansion knows nothing of the kernel's constant core.
      if (distance - radius - node.Radius > InverseBlob<Power>::Core * node.MaxRadius)
      {
        const double inverse = 1.0 / distance;
        const Separation separation{ radius * inverse, node.Radius * inverse,
          node.MeanRadius * inverse };
        const int order =
          OrderFor<Power>(separation, this->Expansions.TruncationError, this->Reduced.Order);
        if (order <= this->Reduced.Order)
        {
          queues.Add(at, direction, inverse, order);
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

  // L2P and P2P.
  void Write(const FieldBlock& block, const LocalExpansion& local, const Nodes& near)
  {
    const FullExpansion expansion = FullExpansionOf(this->Reduced, local, this->Full);
    this->Evaluate(block, local.Center, expansion, this->Grid.Field, 1);
    for (int axis = 0; this->Grid.Gradient && axis < 3; ++axis)
    {
      this->Evaluate(block, local.Center, DerivativeOf(this->Full, expansion, axis),
        this->Grid.Gradient + axis, 3);
    }
    if (!near.empty())
    {
      this->Sum->Begin(this->Grid, block, this->Expansions.Estimate);
      for (const std::int32_t at : near)
      {
        const ChargeNode& node = this->Tree.Nodes[at];
        this->Sum->Add(
          this->Tree.Charges.data() + node.First, node.Count, node.Center, node.Radius);
      }
      this->Sum->End();
    }
  }

  void Evaluate(const FieldBlock& block, const double (&center)[3], const FullExpansion& expansion,
    float* values, int stride) const
  {
    LocalGrid points;
    for (int axis = 0; axis < 3; ++axis)
    {
      points.First[axis] = this->Grid.At(axis, block.First[axis]) - center[axis];
      points.Spacing[axis] = this->Grid.Spacing[axis];
      points.Count[axis] = block.Count[axis];
    }
    EvaluateLocal(this->Full, expansion, points,
      [&](int x, int y, int z, const Float8& value)
      {
        float* to = values +
          stride * this->Grid.Index(block.First[0] + x, block.First[1] + y, block.First[2] + z);
        const int count = std::min(8, block.Count[0] - x);
        for (int i = 0; i < count; ++i)
        {
          to[stride * i] = value[i];
        }
      });
  }

  const FieldGrid& Grid;
  const ChargeTree& Tree;
  const Multipoles& Expansions;
  const MultiIndex& Reduced;
  const MultiIndex& Full;
  Nodes Open; // clusters to be tested
  std::unique_ptr<BlockSum<InverseBlob<Power>>> Sum;
};
}
}

#endif
