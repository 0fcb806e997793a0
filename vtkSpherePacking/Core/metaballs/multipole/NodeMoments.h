// SPDX-License-Identifier: BSD-3-Clause
#ifndef NodeMoments_h
#define NodeMoments_h

#include "metaballs/multipole/AxisShifts.h"
#include "metaballs/multipole/LeafMoments.h"

namespace spherepacking
{
inline namespace SPHEREPACKING_ISA
{
/// M2M: sets the moments of up to eight nodes from those of their children, a node per lane.
inline void MomentsOfChildren(
  const ChargeTree& tree, const std::int32_t* nodes, int count, ClusterMoments& moments)
{
  const MultiIndex& reduced = moments.Reduced;
  Float8 sums[MaxReduced] = {};
  for (int child = 0; child < 2; ++child)
  {
    Float8 shifted[MaxReduced];
    Float8 shift[3] = {};
    Float8 ratio = {}; // of the child's radius to the node's, the units of their moments
    const float* from[8] = {};
    for (int lane = 0; lane < 8; ++lane)
    {
      const ChargeNode& whole = tree.Nodes[nodes[std::min(lane, count - 1)]];
      const ChargeNode& part = tree.Nodes[whole.Child + child];
      const double scale = whole.Radius > 0.0 ? 1.0 / whole.Radius : 0.0;
      for (int axis = 0; axis < 3; ++axis)
      {
        shift[axis][lane] = static_cast<float>(scale * (whole.Center[axis] - part.Center[axis]));
      }
      ratio[lane] = static_cast<float>(scale * part.Radius);
      from[lane] = moments[whole.Child + child];
    }
    Float8 ratios[MaxOrder + 1];
    ratios[0] = Float8{} + 1.0f;
    for (int n = 1; n <= reduced.Order; ++n)
    {
      ratios[n] = ratios[n - 1] * ratio;
    }
    ForEachMonomial(reduced,
      [&](int i, int j, int k, int n) { shifted[n] = ratios[i + j + k] * Gather(from, n); });
    ShiftMoments(reduced, moments.Full, shift, shifted);
    for (int n = 0; n < reduced.Count; ++n)
    {
      sums[n] += shifted[n];
    }
  }
  for (int lane = 0; lane < count; ++lane)
  {
    float* to = moments[nodes[lane]];
    for (int n = 0; n < reduced.Count; ++n)
    {
      to[n] = sums[n][lane];
    }
  }
}

/// Sets the moments of nodes that are all leaves, or that all have children whose moments are set.
inline void SetMomentsImpl(
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
    MomentsOfLeaf(moments.Reduced, tree.Nodes[nodes[i]], tree.Charges.data(), moments[nodes[i]]);
  }
}
}
}

#endif
