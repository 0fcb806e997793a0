// SPDX-License-Identifier: BSD-3-Clause
// Compiled for processors with AVX2 and FMA, see base/Simd.h.
#define SPHEREPACKING_ISA Avx2
#include "metaballs/multilevel/Anterpolate.h"
#include "metaballs/multilevel/GridTransfer.h"

#include "metaballs/multilevel/MultilevelAvx2.h"

namespace spherepacking
{
//------------------------------------------------------------------------------
void AnterpolateCellsAvx2(GridHierarchy& hierarchy, int y, int z)
{
  AnterpolateCellsImpl(hierarchy, y, z);
}

//------------------------------------------------------------------------------
void RestrictAvx2(const GridRows& fine, GridLevel& level, const GridBox& box)
{
  RestrictImpl(fine, level, box);
}

//------------------------------------------------------------------------------
void SetFieldAvx2(GridHierarchy& hierarchy, std::size_t level, const GridBox& box)
{
  SetFieldImpl(hierarchy, level, box);
}
}
