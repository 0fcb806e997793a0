// SPDX-License-Identifier: BSD-3-Clause
#ifndef SumFieldAvx2_h
#define SumFieldAvx2_h

#include "metaballs/multilevel/GridHierarchy.h"
#include "metaballs/FieldScene.h"

namespace spherepacking
{
// For processors with AVX2 and FMA; the results differ from those without by rounding.
void SumFieldAvx2(const FieldScene& scene, const FieldBlock& block);
void FindStrongestAvx2(const FieldScene& scene, const FieldBlock& block);
void ComputeMomentsAvx2(
  const ChargeTree& tree, const std::int32_t* nodes, int count, ClusterMoments& moments);
void SpreadCellsAvx2(FieldMesh& mesh, int y, int z);
void CollectChargesAvx2(const MeshRows& fine, MeshLevel& level, const NodeBox& box);
void MakeMeshFieldAvx2(FieldMesh& mesh, std::size_t level, const NodeBox& box);
}

#endif
