// SPDX-License-Identifier: BSD-3-Clause
#ifndef NodeMoments_h
#define NodeMoments_h

#include "metaballs/multipole/AxisShifts.h"
#include "metaballs/multipole/LeafMoments.h"

namespace spherepacking
{
inline namespace SPHEREPACKING_ISA
{
/// Sets the moments of up to eight nodes from those of their children.
inline void MomentsOfChildren(
  const ChargeTree& tree, const std::int32_t* nodes, int count, ClusterMoments& moments)
{
  const MultiIndex& kept = moments.Kept;
  Float8 sums[MostKept] = {};
  for (int child = 0; child < 2; ++child)
  {
    Float8 shifted[MostKept];
    Float8 away[3] = {};
    Float8 shrink = {};
    const float* from[8] = {};
    for (int lane = 0; lane < 8; ++lane)
    {
      const ChargeNode& whole = tree.Nodes[nodes[std::min(lane, count - 1)]];
      const ChargeNode& part = tree.Nodes[whole.Child + child];
      const double scale = whole.Radius > 0.0 ? 1.0 / whole.Radius : 0.0;
      for (int axis = 0; axis < 3; ++axis)
      {
        away[axis][lane] = static_cast<float>(scale * (whole.Center[axis] - part.Center[axis]));
      }
      shrink[lane] = static_cast<float>(scale * part.Radius);
      from[lane] = moments[whole.Child + child];
    }
    Float8 shrinks[MostOrder + 1];
    shrinks[0] = Float8{} + 1.0f;
    for (int n = 1; n <= kept.Order; ++n)
    {
      shrinks[n] = shrinks[n - 1] * shrink;
    }
    ForEachMonomial(kept,
      [&](int i, int j, int k, int at) { shifted[at] = shrinks[i + j + k] * Gather(from, at); });
    ShiftMoments(kept, moments.All, away, shifted);
    for (int place = 0; place < kept.Count; ++place)
    {
      sums[place] += shifted[place];
    }
  }
  for (int lane = 0; lane < count; ++lane)
  {
    float* to = moments[nodes[lane]];
    for (int place = 0; place < kept.Count; ++place)
    {
      to[place] = sums[place][lane];
    }
  }
}

/// Sets the moments of nodes that are all leaves, or all of which have children that are done.
inline void ComputeMomentsKernel(
  const ChargeTree& tree, const std::int32_t* nodes, int count, ClusterMoments& moments)
{
  if (tree.Nodes[nodes[0]].Child >= 0)
  {
    for (int first = 0; first < count; first += 8)
    {
      MomentsOfChildren(tree, nodes + first, std::min(8, count - first), moments);
    }
    return;
  }
  for (int i = 0; i < count; ++i)
  {
    MomentsOfLeaf(moments.Kept, tree.Nodes[nodes[i]], tree.Charges.data(), moments[nodes[i]]);
  }
}
}
}

#endif
