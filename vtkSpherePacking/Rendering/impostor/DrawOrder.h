// SPDX-License-Identifier: BSD-3-Clause
/// The order in which point sprites are drawn: roughly front to back, in a few batches, so that
/// each batch can be culled against the depths of those before it (HiZBuffer.h).
#ifndef DrawOrder_h
#define DrawOrder_h

#include "impostor/PointSprites.h"
#include "impostor/ViewTransform.h"

#include <vector>

namespace spherepacking
{
/// Up to about this many spheres, deferred shading and culling cost more than they save.
constexpr vtkIdType ManySpheres = 20000;

/// Vertex ranges of one glMultiDrawArrays().
struct DrawRanges
{
  std::vector<int> Firsts;
  std::vector<int> Counts;

  void Add(vtkIdType begin, vtkIdType end);
};

/// Makes the batches for a view. Clusters outside of its depth range are left out. The others are
/// sorted by depth in each square of 64 x 64 pixels, so that every part of the window has its front
/// in the first batch, where it occludes most. Fewer than ManySpheres are one batch.
std::vector<DrawRanges> MakeDrawOrder(const PointSprites& sprites, const ViewTransform& view);
}

#endif
