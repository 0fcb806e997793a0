// SPDX-License-Identifier: BSD-3-Clause
#include "metaballs/multipole/ChargeTree.h"

#include "metaballs/multipole/TruncationError.h"

#include <algorithm>
#include <cmath>

namespace spherepacking
{
namespace
{
// Builds the subtree of a range of charges, down to leaves of at most `leafSize`.
class SubtreeBuilder
{
public:
  SubtreeBuilder(std::vector<Charge>& charges, std::int32_t leafSize)
    : Charges(charges)
    , LeafSize(leafSize)
  {
  }

  // Depth first, with a stack instead of a recursion: trees may be deep.
  std::vector<ChargeNode> Run(std::int32_t first, std::int32_t count)
  {
    std::vector<ChargeNode> nodes(1, NodeOf(first, count));
    std::vector<std::int32_t> stack{ 0 };
    while (!stack.empty())
    {
      const std::int32_t at = stack.back();
      stack.pop_back();
      const int axis = this->Enclose(nodes[at]);
      const ChargeNode node = nodes[at];
      if (node.Count <= this->LeafSize || axis < 0)
      {
        continue;
      }
      const std::int32_t low = this->Split(node, axis);
      const auto child = static_cast<std::int32_t>(nodes.size());
      nodes[at].Child = child;
      nodes.push_back(NodeOf(node.First, low));
      nodes.push_back(NodeOf(node.First + low, node.Count - low));
      stack.push_back(child);
      stack.push_back(child + 1);
    }
    return nodes;
  }

private:
  static ChargeNode NodeOf(std::int32_t first, std::int32_t count)
  {
    ChargeNode node;
    node.First = first;
    node.Count = count;
    return node;
  }

  // Sets the ball of a node, centred in the charges' bounding box, and returns the axis of the
  // box's longest side, or -1 if it is a point.
  int Enclose(ChargeNode& node)
  {
    const Charge* charges = this->Charges.data() + node.First;
    double low[3];
    double high[3];
    std::copy_n(charges[0].Position, 3, low);
    std::copy_n(charges[0].Position, 3, high);
    for (std::int32_t i = 0; i < node.Count; ++i)
    {
      for (int axis = 0; axis < 3; ++axis)
      {
        low[axis] = std::min(low[axis], charges[i].Position[axis]);
        high[axis] = std::max(high[axis], charges[i].Position[axis]);
      }
      node.MaxRadius = std::max(node.MaxRadius, charges[i].Radius);
      node.MaxStrength = std::max(node.MaxStrength, charges[i].Strength);
    }
    int longest = 0;
    double diagonal = 0.0;
    for (int axis = 0; axis < 3; ++axis)
    {
      node.Center[axis] = 0.5 * (low[axis] + high[axis]);
      diagonal += (high[axis] - low[axis]) * (high[axis] - low[axis]);
      longest = high[axis] - low[axis] > high[longest] - low[longest] ? axis : longest;
    }
    double square = 0.0;
    double weights = 0.0;
    double powers = 0.0;
    const double inverse = diagonal > 0.0 ? 1.0 / diagonal : 0.0;
    for (std::int32_t i = 0; i < node.Count; ++i)
    {
      double distance = 0.0;
      for (int axis = 0; axis < 3; ++axis)
      {
        const double away = charges[i].Position[axis] - node.Center[axis];
        distance += away * away;
      }
      square = std::max(square, distance);
      static_assert(MeanPower == 16, "as it is computed here");
      double power = distance * inverse; // at most 1: the 16th power of a length may overflow
      power *= power;
      power *= power;
      weights += charges[i].Strength;
      powers += charges[i].Strength * power * power;
    }
    node.Radius = std::sqrt(square);
    // A little larger, to allow for rounding.
    const double mean = std::sqrt(diagonal) * std::pow(powers / weights, 1.0 / MeanPower);
    node.MeanRadius = std::min(node.Radius, mean * (1.0 + 1e-9));
    this->Middle = node.Center[longest];
    return high[longest] > low[longest] ? longest : -1;
  }

  // Partitions a node's charges and returns how many are in the lower part: those below the middle,
  // or the lower half of them where otherwise one part would be so small that the tree gets deep.
  std::int32_t Split(const ChargeNode& node, int axis)
  {
    Charge* first = this->Charges.data() + node.First;
    Charge* last = first + node.Count;
    const double middle = this->Middle;
    Charge* cut = std::partition(
      first, last, [&](const Charge& charge) { return charge.Position[axis] < middle; });
    const auto below = static_cast<std::int32_t>(cut - first);
    const std::int32_t few = node.Count / 16;
    if (below > few && node.Count - below > few)
    {
      return below;
    }
    cut = first + node.Count / 2;
    std::nth_element(first, cut, last, [axis](const Charge& one, const Charge& other)
      { return one.Position[axis] < other.Position[axis]; });
    return node.Count / 2;
  }

  std::vector<Charge>& Charges;
  const std::int32_t LeafSize;
  double Middle = 0.0;
};

// Splits all leaves of a tree further, down to `leafSize` charges.
void SplitLeaves(ChargeTree& tree, std::int32_t leafSize, const ParallelFor& parallelFor)
{
  std::vector<std::int32_t> roots;
  for (std::size_t i = 0; i < tree.Nodes.size(); ++i)
  {
    if (tree.Nodes[i].Child < 0 && tree.Nodes[i].Count > leafSize)
    {
      roots.push_back(static_cast<std::int32_t>(i));
    }
  }
  std::vector<std::vector<ChargeNode>> subtrees(roots.size());
  parallelFor(static_cast<std::int64_t>(roots.size()),
    [&](std::int64_t i)
    {
      const ChargeNode& root = tree.Nodes[roots[i]];
      subtrees[i] = SubtreeBuilder(tree.Charges, leafSize).Run(root.First, root.Count);
    });
  for (std::size_t i = 0; i < roots.size(); ++i)
  {
    // The subtree's root is in the tree already; its children become the next nodes.
    const auto shift = static_cast<std::int32_t>(tree.Nodes.size()) - 1;
    for (ChargeNode& node : subtrees[i])
    {
      node.Child += node.Child < 0 ? 0 : shift;
    }
    tree.Nodes[roots[i]].Child = subtrees[i].front().Child;
    tree.Nodes.insert(tree.Nodes.end(), subtrees[i].begin() + 1, subtrees[i].end());
  }
}
}

//------------------------------------------------------------------------------
ChargeTree BuildChargeTree(
  std::vector<Charge>&& charges, std::int32_t leafSize, const ParallelFor& parallelFor)
{
  ChargeTree tree;
  tree.Charges = std::move(charges);
  if (tree.Charges.empty())
  {
    return tree;
  }
  // Level by level in parallel: the first splits make too few subtrees for all threads, later ones
  // subtrees that are little work each.
  const auto count = static_cast<std::int32_t>(tree.Charges.size());
  tree.Nodes = SubtreeBuilder(tree.Charges, std::max(leafSize, count / 4)).Run(0, count);
  for (std::int32_t size = count / 4; size > leafSize;)
  {
    size = size > 16384 ? size / 4 : leafSize;
    SplitLeaves(tree, size, parallelFor);
  }
  return tree;
}
}
