// SPDX-License-Identifier: BSD-3-Clause
#include "metaballs/FieldScene.h"

#include "metaballs/field/Blobs.h"
#include "metaballs/multilevel/GaussianSum.h"

#include <algorithm>
#include <cmath>

namespace spherepacking
{
namespace
{
constexpr int LeafSize = 32;

double StrengthOf(BlobKind kind, double weight, double radius)
{
  switch (kind)
  {
    case BlobKind::Inverse:
      return InverseBlob<1>::Strength(weight, radius);
    case BlobKind::InverseSquare:
      return InverseBlob<2>::Strength(weight, radius);
    default:
      return weight;
  }
}

struct BlockSize
{
  std::int64_t Length[3]; // in points

  std::int64_t Blocks(const FieldGrid& grid) const
  {
    std::int64_t blocks = 1;
    for (int axis = 0; axis < 3; ++axis)
    {
      blocks *= (grid.Dimensions[axis] + this->Length[axis] - 1) / this->Length[axis];
    }
    return blocks;
  }
};

// A cube of `side`^3 points, or where the grid is thinner a longer block with as many points.
BlockSize BlockSizeOf(const FieldGrid& grid, std::int64_t side)
{
  constexpr double longest = 512.0; // see LocalGrid
  int axes[3] = { 0, 1, 2 };
  std::sort(axes, axes + 3, [&](int a, int b) { return grid.Dimensions[a] < grid.Dimensions[b]; });
  BlockSize size;
  auto points = static_cast<double>(side * side * side);
  for (int i = 0; i < 3; ++i)
  {
    const double length = std::min(std::pow(points, 1.0 / (3 - i)), longest);
    const auto whole = static_cast<std::int64_t>(8.0 * std::max(std::round(length / 8.0), 1.0));
    size.Length[axes[i]] = whole;
    points /= static_cast<double>(std::min(whole, grid.Dimensions[axes[i]]));
  }
  return size;
}
}

//------------------------------------------------------------------------------
FieldScene PrepareField(BlobKind kind, std::vector<Charge>&& spheres, double relativeError,
  const FieldGrid& grid, FieldWanted wanted, const ParallelFor& parallelFor)
{
  std::vector<Charge> charges = std::move(spheres);
  FieldScene scene;
  scene.Kind = kind;
  scene.Grid = grid;
  scene.RelativeError = relativeError;
  for (Charge& charge : charges)
  {
    scene.MaxWeight = std::max(scene.MaxWeight, static_cast<double>(charge.Strength));
    charge.Strength = static_cast<float>(StrengthOf(kind, charge.Strength, charge.Radius));
  }
  charges.erase(std::remove_if(charges.begin(), charges.end(), [](const Charge& charge)
                  { return !(charge.Strength > 0.0f && charge.Radius > 0.0f); }),
    charges.end());
  const bool inverse = kind == BlobKind::Inverse || kind == BlobKind::InverseSquare;
  const int power = kind == BlobKind::Inverse ? 1 : 2;
  // Multilevel summation makes no gradients, and the strongest are found through the tree.
  if (inverse && !wanted.Gradient && !wanted.Strongest && relativeError >= GaussianSumError &&
    SuitsMultilevel(charges, grid, power))
  {
    scene.Hierarchy = BuildGridHierarchy(std::move(charges), grid, power, parallelFor);
    return scene;
  }
  scene.Tree = BuildChargeTree(std::move(charges), LeafSize, parallelFor);
  if (inverse && relativeError > 0.0 && !scene.Tree.Nodes.empty())
  {
    scene.Expansions = std::make_unique<Multipoles>(
      ComputeMultipoles(scene.Tree, power, relativeError, parallelFor));
  }
  return scene;
}

//------------------------------------------------------------------------------
FieldScene PrepareField(BlobKind kind, std::vector<Charge>&& spheres, double relativeError,
  const ParallelFor& parallelFor)
{
  return PrepareField(kind, std::move(spheres), relativeError, FieldGrid{}, {}, parallelFor);
}

//------------------------------------------------------------------------------
std::vector<FieldBlock> CutIntoBlocks(const FieldScene& scene)
{
  const FieldGrid& grid = scene.Grid;
  // For multilevel summation: long rows fill vectors, and a large block has the fewest points
  // around it from which stencils read.
  BlockSize size{ { 1024, 32, 8 } };
  if (!scene.Hierarchy)
  {
    constexpr std::int64_t enough = 64; // for all cores
    std::int64_t side = 32;
    do
    {
      size = BlockSizeOf(grid, side);
      side /= 2;
    } while (side >= 8 && size.Blocks(grid) < enough);
  }
  std::vector<FieldBlock> blocks;
  for (std::int64_t z = 0; z < grid.Dimensions[2]; z += size.Length[2])
  {
    for (std::int64_t y = 0; y < grid.Dimensions[1]; y += size.Length[1])
    {
      for (std::int64_t x = 0; x < grid.Dimensions[0]; x += size.Length[0])
      {
        FieldBlock block{ { x, y, z }, {} };
        for (int axis = 0; axis < 3; ++axis)
        {
          block.Count[axis] = static_cast<int>(
            std::min<std::int64_t>(size.Length[axis], grid.Dimensions[axis] - block.First[axis]));
        }
        blocks.push_back(block);
      }
    }
  }
  return blocks;
}
}
