// SPDX-License-Identifier: BSD-3-Clause
/// A field that is to be summed: of what, where and how exactly.
#ifndef FieldScene_h
#define FieldScene_h

#include "metaballs/FieldGrid.h"
#include "metaballs/Moments.h"
#include "metaballs/TranslationIndex.h"

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

struct FieldScene
{
  BlobKind Kind = BlobKind::Inverse;
  FieldGrid Grid;
  ChargeTree Tree;
  double Error = 1e-3;   ///< relative, of a cluster's field; 0 to sum all one by one
  bool Estimate = false; ///< the error allows spheres one by one to be wrong by EstimateError
  double MostWeight = 0.0;
  ClusterMoments Moments;
  std::vector<TranslationIndex> Indices; ///< of each order up to that of the moments
  std::vector<float> Nothing;            ///< moments of no charges
};

/// Takes spheres whose strengths are their weights; those of radius or weight 0 are left out.
/// Lengths are best scaled so that the spheres and the grid, which Grid is to be set to, are about
/// 1 long.
FieldScene PrepareField(BlobKind kind, std::vector<Charge>&& spheres, double relativeError,
  const ParallelFor& parallelFor);

/// Parts of a grid, each some milliseconds of work.
std::vector<FieldBlock> CutIntoBlocks(const FieldGrid& grid);

/// Sets the field, and the gradient if it is wanted, at the places of a block.
void SumField(const FieldScene& scene, const FieldBlock& block);

/// Sets the id of the sphere that adds most, -1 where none adds anything; the lowest of equals.
/// Without charges the ids stay what they are.
void FindStrongest(const FieldScene& scene, const FieldBlock& block);
}

#endif
