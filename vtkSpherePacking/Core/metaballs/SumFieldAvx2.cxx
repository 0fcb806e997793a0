// SPDX-License-Identifier: BSD-3-Clause
// Compiled for processors with AVX2 and FMA, see base/Simd.h.
#define SPHEREPACKING_ISA Avx2
#include "metaballs/SumFieldImpl.h"

#include "metaballs/SumFieldAvx2.h"

namespace spherepacking
{
//------------------------------------------------------------------------------
void SumFieldAvx2(const FieldScene& scene, const FieldBlock& block)
{
  SumFieldImpl(scene, block);
}

//------------------------------------------------------------------------------
void FindStrongestAvx2(const FieldScene& scene, const FieldBlock& block)
{
  FindStrongestImpl(scene, block);
}
}
