// SPDX-License-Identifier: BSD-3-Clause
/// Which sum is made for which kernel.
#ifndef SumFieldImpl_h
#define SumFieldImpl_h

#include "metaballs/multipole/MultipoleSum.h"
#include "metaballs/multilevel/MultilevelSum.h"
#include "metaballs/StrongestFinder.h"

namespace spherepacking
{
inline namespace SPHEREPACKING_ISA
{
template <int Power>
inline void SumInverse(const FieldScene& scene, const FieldBlock& block)
{
  if (scene.Mesh)
  {
    MeshSummer<Power>(scene).Run(block);
  }
  else if (scene.Error > 0.0 && !scene.Tree.Nodes.empty())
  {
    FieldSummer<Power>(scene).Run(block);
  }
  else
  {
    NearSummer<InverseBlob<Power>>(scene).Run(block);
  }
}

inline void SumFieldKernel(const FieldScene& scene, const FieldBlock& block)
{
  switch (scene.Kind)
  {
    case BlobKind::Inverse:
      return SumInverse<1>(scene, block);
    case BlobKind::InverseSquare:
      return SumInverse<2>(scene, block);
    case BlobKind::Gaussian:
      return NearSummer<GaussianBlob>(scene).Run(block);
    case BlobKind::Wyvill:
      return NearSummer<WyvillBlob>(scene).Run(block);
  }
}

inline void FindStrongestKernel(const FieldScene& scene, const FieldBlock& block)
{
  if (scene.Tree.Nodes.empty())
  {
    return;
  }
  switch (scene.Kind)
  {
    case BlobKind::Inverse:
      return StrongestFinder<InverseBlob<1>>(scene).Run(block);
    case BlobKind::InverseSquare:
      return StrongestFinder<InverseBlob<2>>(scene).Run(block);
    case BlobKind::Gaussian:
      return StrongestFinder<GaussianBlob>(scene).Run(block);
    case BlobKind::Wyvill:
      return StrongestFinder<WyvillBlob>(scene).Run(block);
  }
}
}
}

#endif
