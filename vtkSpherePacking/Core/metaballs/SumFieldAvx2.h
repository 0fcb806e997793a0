// SPDX-License-Identifier: BSD-3-Clause
#ifndef SumFieldAvx2_h
#define SumFieldAvx2_h

#include "metaballs/FieldScene.h"

namespace spherepacking
{
/// SumField() and FindStrongest() for processors with AVX2 and FMA; the results differ by rounding.
void SumFieldAvx2(const FieldScene& scene, const FieldBlock& block);
void FindStrongestAvx2(const FieldScene& scene, const FieldBlock& block);
}

#endif
