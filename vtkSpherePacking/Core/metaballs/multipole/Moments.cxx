// SPDX-License-Identifier: BSD-3-Clause
#include "metaballs/multipole/Moments.h"

#include "base/Dispatch.h"
#include "metaballs/multipole/NodeMoments.h"

#if defined(SPHEREPACKING_HAS_AVX2)
#include "metaballs/SumFieldAvx2.h"
#endif

namespace spherepacking
{
namespace
{
// Leaves first; the height of a node is one more than that of its higher child.
std::vector<std::vector<std::int32_t>> NodesByHeight(const ChargeTree& tree)
{
  std::vector<std::int32_t> heights(tree.Nodes.size(), 0);
  std::vector<std::vector<std::int32_t>> nodes;
  // Children come after their parents.
  for (std::size_t i = tree.Nodes.size(); i-- > 0;)
  {
    const std::int32_t child = tree.Nodes[i].Child;
    heights[i] = child < 0 ? 0 : 1 + std::max(heights[child], heights[child + 1]);
    nodes.resize(std::max(nodes.size(), static_cast<std::size_t>(heights[i]) + 1));
    nodes[heights[i]].push_back(static_cast<std::int32_t>(i));
  }
  return nodes;
}

void Compute(const ChargeTree& tree, const std::int32_t* nodes, int count, ClusterMoments& moments)
{
#if defined(SPHEREPACKING_HAS_AVX2)
  if (HasAvx2())
  {
    ComputeMomentsAvx2(tree, nodes, count, moments);
    return;
  }
#endif
  ComputeMomentsKernel(tree, nodes, count, moments);
}
}

//------------------------------------------------------------------------------
ClusterMoments ComputeMoments(
  const ChargeTree& tree, const MultiIndex& kept, const ParallelFor& parallelFor)
{
  ClusterMoments moments;
  moments.Kept = kept;
  moments.All = MultiIndex(kept.Order, kept.Order);
  moments.Values = HugeArray<float>(tree.Nodes.size() * kept.Count);
  // Nodes whose children are done, those of a height after another.
  constexpr std::int64_t part = 32;
  for (const std::vector<std::int32_t>& nodes : NodesByHeight(tree))
  {
    const auto number = static_cast<std::int64_t>(nodes.size());
    parallelFor((number + part - 1) / part,
      [&](std::int64_t i)
      {
        const std::int64_t first = i * part;
        Compute(
          tree, nodes.data() + first, static_cast<int>(std::min(part, number - first)), moments);
      });
  }
  return moments;
}
}
