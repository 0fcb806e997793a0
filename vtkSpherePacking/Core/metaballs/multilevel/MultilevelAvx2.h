// SPDX-License-Identifier: BSD-3-Clause
#ifndef MultilevelAvx2_h
#define MultilevelAvx2_h

#include "metaballs/multilevel/GridHierarchy.h"

namespace spherepacking
{
/// AnterpolateCellsImpl(), RestrictImpl() and SetFieldImpl() for processors with AVX2 and FMA; the
/// results differ by rounding.
void AnterpolateCellsAvx2(GridHierarchy& hierarchy, int y, int z);
void RestrictAvx2(const GridRows& fine, GridLevel& level, const GridBox& box);
void SetFieldAvx2(GridHierarchy& hierarchy, std::size_t level, const GridBox& box);
}

#endif
