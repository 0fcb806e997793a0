// SPDX-License-Identifier: BSD-3-Clause
/// The field of a packing on a grid: what is summed, where, and by which method.
#ifndef FieldScene_h
#define FieldScene_h

#include "metaballs/field/FieldGrid.h"
#include "metaballs/multilevel/GridHierarchy.h"
#include "metaballs/multipole/Multipoles.h"

#include <memory>

namespace spherepacking
{
/// The kernels of Blobs.h.
enum class BlobKind
{
  Inverse,
  InverseSquare,
  Gaussian,
  Wyvill
};

/// What is wanted beside the field itself.
struct FieldWanted
{
  bool Gradient = false;
  bool Strongest = false;
};

/// The field is summed by multilevel summation if there is a hierarchy, by the fast multipole
/// method if there are multipoles, and directly if there is neither.
struct FieldScene
{
  BlobKind Kind = BlobKind::Inverse;
  FieldGrid Grid;
  double RelativeError = 1e-3; ///< bound for that of the field; 0: all charges are summed directly
  double MaxWeight = 0.0;      ///< of the spheres
  ChargeTree Tree;             ///< of all charges if there is no hierarchy
  std::unique_ptr<Multipoles> Expansions;
  std::unique_ptr<GridHierarchy> Hierarchy;
};

/// Takes spheres whose strengths are their weights; those of radius or weight 0 are ignored.
/// Lengths are best scaled so that spheres and grid together are about 1 long. The arrays of the
/// grid may be missing yet, but only what is wanted may be among them later.
FieldScene PrepareField(BlobKind kind, std::vector<Charge>&& spheres, double relativeError,
  const FieldGrid& grid, FieldWanted wanted, const ParallelFor& parallelFor);

/// For grids that are chosen later: never a hierarchy.
FieldScene PrepareField(BlobKind kind, std::vector<Charge>&& spheres, double relativeError,
  const ParallelFor& parallelFor);

/// Cuts a grid into blocks, each of which takes some milliseconds.
std::vector<FieldBlock> CutIntoBlocks(const FieldScene& scene);

/// Sets the field, and the gradient if it is wanted, at the points of a block.
void SumField(const FieldScene& scene, const FieldBlock& block);

/// Sets the id of the sphere that adds most, -1 where none adds anything; the lowest id of equals.
/// Without charges the ids are not set.
void FindStrongest(const FieldScene& scene, const FieldBlock& block);
}

#endif
