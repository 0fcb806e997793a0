// SPDX-License-Identifier: BSD-3-Clause
#include "base/Dispatch.h"
#include "metaballs/SumFieldImpl.h"

#if defined(SPHEREPACKING_HAS_AVX2)
#include "metaballs/SumFieldAvx2.h"
#endif

namespace spherepacking
{
//------------------------------------------------------------------------------
void SumField(const FieldScene& scene, const FieldBlock& block)
{
#if defined(SPHEREPACKING_HAS_AVX2)
  if (HasAvx2())
  {
    SumFieldAvx2(scene, block);
    return;
  }
#endif
  SumFieldKernel(scene, block);
}

//------------------------------------------------------------------------------
void FindStrongest(const FieldScene& scene, const FieldBlock& block)
{
#if defined(SPHEREPACKING_HAS_AVX2)
  if (HasAvx2())
  {
    FindStrongestAvx2(scene, block);
    return;
  }
#endif
  FindStrongestKernel(scene, block);
}
}
