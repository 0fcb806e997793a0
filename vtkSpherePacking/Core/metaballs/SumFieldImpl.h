// SPDX-License-Identifier: BSD-3-Clause
/// Chooses the method and the kernel of a sum.
#ifndef SumFieldImpl_h
#define SumFieldImpl_h

#include "metaballs/DirectSum.h"
#include "metaballs/StrongestFinder.h"
#include "metaballs/multilevel/MultilevelSum.h"
#include "metaballs/multipole/MultipoleSum.h"

namespace spherepacking
{
inline namespace SPHEREPACKING_ISA
{
template <int Power>
inline void SumInverse(const FieldScene& scene, const FieldBlock& block)
{
  if (scene.Hierarchy)
  {
    MultilevelSum<Power>(scene.Grid, *scene.Hierarchy).Run(block);
  }
  else if (scene.Expansions)
  {
    MultipoleSum<Power>(scene.Grid, scene.Tree, *scene.Expansions).Run(block);
  }
  else
  {
    DirectSum<InverseBlob<Power>>(scene).Run(block);
  }
}

inline void SumFieldImpl(const FieldScene& scene, const FieldBlock& block)
{
  switch (scene.Kind)
  {
    case BlobKind::Inverse:
      return SumInverse<1>(scene, block);
    case BlobKind::InverseSquare:
      return SumInverse<2>(scene, block);
    case BlobKind::Gaussian:
      return DirectSum<GaussianBlob>(scene).Run(block);
    case BlobKind::Wyvill:
      return DirectSum<WyvillBlob>(scene).Run(block);
  }
}

inline void FindStrongestImpl(const FieldScene& scene, const FieldBlock& block)
{
  if (scene.Tree.Nodes.empty())
  {
    return;
  }
  switch (scene.Kind)
  {
    case BlobKind::Inverse:
      return StrongestFinder<InverseBlob<1>>(scene.Grid, scene.Tree).Run(block);
    case BlobKind::InverseSquare:
      return StrongestFinder<InverseBlob<2>>(scene.Grid, scene.Tree).Run(block);
    case BlobKind::Gaussian:
      return StrongestFinder<GaussianBlob>(scene.Grid, scene.Tree).Run(block);
    case BlobKind::Wyvill:
      return StrongestFinder<WyvillBlob>(scene.Grid, scene.Tree).Run(block);
  }
}
}
}

#endif
