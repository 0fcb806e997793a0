// SPDX-License-Identifier: BSD-3-Clause
// Compiled for processors with AVX2 and FMA. Names from here end in a namespace of their own, so
// that the linker never takes one of these functions for the one that runs everywhere.
#define SPHEREPACKING_ISA Avx2
#include "metaballs/SumFieldImpl.h"
#include "metaballs/multipole/NodeMoments.h"
#include "metaballs/multilevel/Anterpolate.h"

#include "metaballs/SumFieldAvx2.h"

namespace spherepacking
{
//------------------------------------------------------------------------------
void SumFieldAvx2(const FieldScene& scene, const FieldBlock& block)
{
  SumFieldKernel(scene, block);
}

//------------------------------------------------------------------------------
void FindStrongestAvx2(const FieldScene& scene, const FieldBlock& block)
{
  FindStrongestKernel(scene, block);
}

//------------------------------------------------------------------------------
void ComputeMomentsAvx2(
  const ChargeTree& tree, const std::int32_t* nodes, int count, ClusterMoments& moments)
{
  ComputeMomentsKernel(tree, nodes, count, moments);
}
//------------------------------------------------------------------------------
void SpreadCellsAvx2(FieldMesh& mesh, int y, int z)
{
  SpreadCells(mesh, y, z);
}

//------------------------------------------------------------------------------
void CollectChargesAvx2(const MeshRows& fine, MeshLevel& level, const NodeBox& box)
{
  CollectCharges(fine, level, box);
}

//------------------------------------------------------------------------------
void MakeMeshFieldAvx2(FieldMesh& mesh, std::size_t level, const NodeBox& box)
{
  MakeMeshField(mesh, level, box);
}
}
