// SPDX-License-Identifier: BSD-3-Clause
/// A field that is to be summed: of what, where and how exactly.
#ifndef FieldScene_h
#define FieldScene_h

#include "metaballs/field/FieldGrid.h"
#include "metaballs/multilevel/GridHierarchy.h"
#include "metaballs/multipole/Moments.h"
#include "metaballs/multipole/TranslationIndex.h"

namespace spherepacking
{
/// See Blobs.h.
enum class BlobKind
{
  Inverse,
  InverseSquare,
  Gaussian,
  Wyvill
};

/// What is to be computed beside the field.
struct FieldWanted
{
  bool Gradient = false;
  bool Strongest = false;
};

struct FieldScene
{
  BlobKind Kind = BlobKind::Inverse;
  FieldGrid Grid;
  ChargeTree Tree;
  std::unique_ptr<FieldMesh> Mesh; ///< in place of the tree, or null
  double Error = 1e-3;             ///< relative, of a cluster's field; 0 to sum all one by one
  bool Estimate = false; ///< the error allows spheres one by one to be wrong by EstimateError
  double MostWeight = 0.0;
  ClusterMoments Moments;
  std::vector<TranslationIndex> Indices; ///< of each order up to that of the moments
  std::vector<float> Nothing;            ///< moments of no charges
};

/// Takes spheres whose strengths are their weights; those of radius or weight 0 are left out.
/// Lengths are best scaled so that the spheres and the grid are about 1 long. The grid's arrays
/// need not be there yet, but what is said to be wanted is what they may be.
FieldScene PrepareField(BlobKind kind, std::vector<Charge>&& spheres, double relativeError,
  const FieldGrid& grid, FieldWanted wanted, const ParallelFor& parallelFor);

/// For grids that are chosen later.
FieldScene PrepareField(BlobKind kind, std::vector<Charge>&& spheres, double relativeError,
  const ParallelFor& parallelFor);

/// Parts of a grid, each some milliseconds of work.
std::vector<FieldBlock> CutIntoBlocks(const FieldScene& scene);

/// Sets the field, and the gradient if it is wanted, at the places of a block.
void SumField(const FieldScene& scene, const FieldBlock& block);

/// Sets the id of the sphere that adds most, -1 where none adds anything; the lowest of equals.
/// Without charges the ids stay what they are.
void FindStrongest(const FieldScene& scene, const FieldBlock& block);
}

#endif
