// SPDX-License-Identifier: BSD-3-Clause
#include "metaballs/FieldScene.h"

#include "metaballs/field/Blobs.h"

#include <algorithm>
#include <cmath>

namespace spherepacking
{
namespace
{
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

// More make fewer clusters too near, but each of them slower; these are the fastest.
int OrderOf(int power, double relativeError)
{
  const double order = std::round((power == 1 ? 9.0 : 3.0) - 2.0 * std::log10(relativeError));
  return static_cast<int>(std::min(std::max(order, 2.0), static_cast<double>(MostOrderOf(power))));
}

// What rounding in single precision adds at most where charges are summed one by one, see
// BlockSum.h.
constexpr double Rounding = 1e-5;
// The rest of the error is for rounding in expansions: monomials of degree n add up to no more than
// (1 + sqrt(2))^n t^n, and t^(p + 1) is about the error, so 2^-24 of them is below a tenth of it.
constexpr double Truncation = 0.9;
constexpr int Leaf = 32;

struct BlockSides
{
  std::int64_t Length[3]; // in places

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

// Of cubes, or where the grid is thinner than these of longer blocks with as many places.
BlockSides SidesOf(const FieldGrid& grid, std::int64_t side)
{
  constexpr double longest = 512.0; // see LocalGrid
  int axes[3] = { 0, 1, 2 };
  std::sort(axes, axes + 3, [&](int a, int b) { return grid.Dimensions[a] < grid.Dimensions[b]; });
  BlockSides sides;
  auto places = static_cast<double>(side * side * side);
  for (int i = 0; i < 3; ++i)
  {
    const double length = std::min(std::pow(places, 1.0 / (3 - i)), longest);
    const auto whole = static_cast<std::int64_t>(8.0 * std::max(std::round(length / 8.0), 1.0));
    sides.Length[axes[i]] = whole;
    places /= static_cast<double>(std::min(whole, grid.Dimensions[axes[i]]));
  }
  return sides;
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
  for (Charge& charge : charges)
  {
    scene.MostWeight = std::max(scene.MostWeight, static_cast<double>(charge.Strength));
    charge.Strength = static_cast<float>(StrengthOf(kind, charge.Strength, charge.Radius));
  }
  charges.erase(std::remove_if(charges.begin(), charges.end(), [](const Charge& charge)
                  { return !(charge.Strength > 0.0f && charge.Radius > 0.0f); }),
    charges.end());
  const bool expanded = kind == BlobKind::Inverse || kind == BlobKind::InverseSquare;
  const int power = kind == BlobKind::Inverse ? 1 : 2;
  // The strongest are found through the tree.
  if (expanded && !wanted.Gradient && !wanted.Strongest && relativeError >= GaussianSumError &&
    IsForMesh(charges, grid, power))
  {
    scene.Mesh = BuildFieldMesh(std::move(charges), grid, power, parallelFor);
    return scene;
  }
  scene.Tree = BuildChargeTree(std::move(charges), Leaf, parallelFor);
  scene.Error = relativeError > 0.0 ? Truncation * relativeError - Rounding : 0.0;
  if (relativeError > 0.0 && expanded)
  {
    const int order = OrderOf(power, relativeError);
    scene.Estimate = relativeError >= EstimateError + Rounding;
    for (int i = 0; i <= order; ++i)
    {
      scene.Indices.emplace_back(power, i);
    }
    scene.Moments = ComputeMoments(scene.Tree, scene.Indices.back().Kept, parallelFor);
    scene.Nothing.assign(MostKept, 0.0f);
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
  // Long rows are summed fastest, and least is done for the nodes about a block.
  BlockSides sides{ { 1024, 32, 8 } };
  if (!scene.Mesh)
  {
    constexpr std::int64_t enough = 64; // for all cores
    std::int64_t side = 32;
    do
    {
      sides = SidesOf(grid, side);
      side /= 2;
    } while (side >= 8 && sides.Blocks(grid) < enough);
  }
  std::vector<FieldBlock> blocks;
  for (std::int64_t z = 0; z < grid.Dimensions[2]; z += sides.Length[2])
  {
    for (std::int64_t y = 0; y < grid.Dimensions[1]; y += sides.Length[1])
    {
      for (std::int64_t x = 0; x < grid.Dimensions[0]; x += sides.Length[0])
      {
        FieldBlock block{ { x, y, z }, {} };
        for (int axis = 0; axis < 3; ++axis)
        {
          block.Count[axis] = static_cast<int>(
            std::min<std::int64_t>(sides.Length[axis], grid.Dimensions[axis] - block.First[axis]));
        }
        blocks.push_back(block);
      }
    }
  }
  return blocks;
}
}
