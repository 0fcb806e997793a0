// SPDX-License-Identifier: BSD-3-Clause
// Compiled for processors with AVX2 and FMA. Names from here end in a namespace of their own, so
// that the linker never takes one of these functions for the one that runs everywhere.
#define SPHEREPACKING_ISA Avx2
#include "metaballs/FieldKernel.h"
#include "metaballs/MomentsKernel.h"

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
}
