// SPDX-License-Identifier: BSD-3-Clause
#ifndef DirectSum_h
#define DirectSum_h

#include "base/LocalVector.h"
#include "metaballs/FieldScene.h"
#include "metaballs/field/BlockSum.h"

#include <memory>

namespace spherepacking
{
inline namespace SPHEREPACKING_ISA
{
/// Calls visit(part) for parts of a block that are small enough for BlockSum.
template <typename Visit>
inline void ForEachPart(const FieldBlock& block, Visit visit)
{
  for (int z = 0; z < block.Count[2]; z += MaxBlockWidth)
  {
    for (int y = 0; y < block.Count[1]; y += MaxBlockWidth)
    {
      for (int x = 0; x < block.Count[0]; x += MaxBlockWidth)
      {
        visit(FieldBlock{ { block.First[0] + x, block.First[1] + y, block.First[2] + z },
          { std::min(MaxBlockWidth, block.Count[0] - x),
            std::min(MaxBlockWidth, block.Count[1] - y),
            std::min(MaxBlockWidth, block.Count[2] - z) } });
      }
    }
  }
}

/// Direct summation, of all charges or, if an error is allowed, of those whose support reaches the
/// points.
template <typename Blob>
class DirectSum
{
public:
  explicit DirectSum(const FieldScene& scene)
    : Scene(scene)
    , Sum(new BlockSum<Blob>)
  {
  }

  /// Sets the grid's arrays at the points of a block.
  void Run(const FieldBlock& block)
  {
    ForEachPart(block,
      [this](const FieldBlock& part)
      {
        this->SetZero(part);
        this->Sum->Begin(this->Scene.Grid, part, false);
        const std::vector<Charge>& charges = this->Scene.Tree.Charges;
        if (this->Scene.RelativeError > 0.0 && !charges.empty())
        {
          this->AddThoseInReach(part);
        }
        else
        {
          this->Sum->Add(charges.data(), static_cast<std::int32_t>(charges.size()));
        }
        this->Sum->End();
      });
  }

private:
  // Bound for the sum of all charges that are neglected, in units of the largest weight.
  static constexpr double NeglectedWeight = 5e-7;

  void SetZero(const FieldBlock& part) const
  {
    const FieldGrid& grid = this->Scene.Grid;
    for (int z = 0; z < part.Count[2]; ++z)
    {
      for (int y = 0; y < part.Count[1]; ++y)
      {
        const std::int64_t first = grid.Index(part.First[0], part.First[1] + y, part.First[2] + z);
        std::fill_n(grid.Field + first, part.Count[0], 0.0f);
        if (grid.Gradient)
        {
          std::fill_n(grid.Gradient + 3 * first, 3 * part.Count[0], 0.0f);
        }
      }
    }
  }

  void AddThoseInReach(const FieldBlock& part)
  {
    const double cutoff = NeglectedWeight * this->Scene.MaxWeight /
      static_cast<double>(this->Scene.Tree.Charges.size());
    this->Open.assign(1, 0);
    while (!this->Open.empty())
    {
      const ChargeNode& node = this->Scene.Tree.Nodes[this->Open.back()];
      this->Open.pop_back();
      const double reach = node.Radius + Blob::Support(node.MaxStrength, node.MaxRadius, cutoff);
      double square = 0.0;
      for (int axis = 0; axis < 3; ++axis)
      {
        const double low = this->Scene.Grid.At(axis, part.First[axis]);
        const double high = this->Scene.Grid.At(axis, part.First[axis] + part.Count[axis] - 1);
        const double outside =
          std::max(std::max(low - node.Center[axis], node.Center[axis] - high), 0.0);
        square += outside * outside;
      }
      if (square > reach * reach)
      {
        continue;
      }
      if (node.Child >= 0)
      {
        this->Open.push_back(node.Child);
        this->Open.push_back(node.Child + 1);
      }
      else
      {
        this->Sum->Add(
          this->Scene.Tree.Charges.data() + node.First, node.Count, node.Center, node.Radius);
      }
    }
  }

  const FieldScene& Scene;
  LocalVector<std::int32_t> Open; // nodes to be tested
  std::unique_ptr<BlockSum<Blob>> Sum;
};
}
}

#endif
