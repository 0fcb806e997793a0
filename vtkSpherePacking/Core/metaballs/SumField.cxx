// SPDX-License-Identifier: BSD-3-Clause
#include "base/Dispatch.h"
#include "metaballs/SumFieldAvx2.h"
#include "metaballs/SumFieldImpl.h"

namespace spherepacking
{
//------------------------------------------------------------------------------
void SumField(const FieldScene& scene, const FieldBlock& block)
{
  SPHEREPACKING_DISPATCH(SumField)(scene, block);
}

//------------------------------------------------------------------------------
void FindStrongest(const FieldScene& scene, const FieldBlock& block)
{
  SPHEREPACKING_DISPATCH(FindStrongest)(scene, block);
}
}
