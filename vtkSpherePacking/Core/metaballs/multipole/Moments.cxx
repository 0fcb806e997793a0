// SPDX-License-Identifier: BSD-3-Clause
#include "metaballs/multipole/Moments.h"

#include "base/Dispatch.h"
#include "metaballs/multipole/MomentsAvx2.h"
#include "metaballs/multipole/NodeMoments.h"

namespace spherepacking
{
namespace
{
// Nodes by their height: 0 for leaves, else one more than that of the higher child.
std::vector<std::vector<std::int32_t>> NodesByHeight(const ChargeTree& tree)
{
  std::vector<std::int32_t> heights(tree.Nodes.size(), 0);
  std::vector<std::vector<std::int32_t>> nodes;
  for (std::size_t i = tree.Nodes.size(); i-- > 0;)
  {
    const std::int32_t child = tree.Nodes[i].Child;
    heights[i] = child < 0 ? 0 : 1 + std::max(heights[child], heights[child + 1]);
    nodes.resize(std::max(nodes.size(), static_cast<std::size_t>(heights[i]) + 1));
    nodes[heights[i]].push_back(static_cast<std::int32_t>(i));
  }
  return nodes;
}
}

//------------------------------------------------------------------------------
ClusterMoments ComputeMoments(
  const ChargeTree& tree, const MultiIndex& reduced, const ParallelFor& parallelFor)
{
  ClusterMoments moments;
  moments.Reduced = reduced;
  moments.Full = MultiIndex(reduced.Order, reduced.Order);
  moments.Values = HugeArray<float>(tree.Nodes.size() * reduced.Count);
  constexpr std::int64_t together = 32;
  for (const std::vector<std::int32_t>& nodes : NodesByHeight(tree))
  {
    const auto number = static_cast<std::int64_t>(nodes.size());
    parallelFor((number + together - 1) / together,
      [&](std::int64_t i)
      {
        const std::int64_t first = i * together;
        SPHEREPACKING_DISPATCH(SetMoments)
        (tree, nodes.data() + first, static_cast<int>(std::min(together, number - first)), moments);
      });
  }
  return moments;
}
}
