// SPDX-License-Identifier: BSD-3-Clause
#include "metaballs/multipole/ChargeTree.h"

#include "metaballs/multipole/TruncationError.h"

#include <algorithm>
#include <cmath>

namespace spherepacking
{
namespace
{
// Halves a node and its parts until they have no more than `leaf` charges.
class Builder
{
public:
  Builder(std::vector<Charge>& charges, std::int32_t leaf)
    : Charges(charges)
    , Leaf(leaf)
  {
  }

  // Depth first, with a list instead of a recursion: trees may be deep.
  std::vector<ChargeNode> Run(std::int32_t first, std::int32_t count)
  {
    std::vector<ChargeNode> nodes(1, NodeOf(first, count));
    std::vector<std::int32_t> left{ 0 };
    while (!left.empty())
    {
      const std::int32_t at = left.back();
      left.pop_back();
      const int axis = this->Enclose(nodes[at]);
      const ChargeNode node = nodes[at];
      if (node.Count <= this->Leaf || axis < 0)
      {
        continue;
      }
      const std::int32_t low = this->Split(node, axis);
      const auto child = static_cast<std::int32_t>(nodes.size());
      nodes[at].Child = child;
      nodes.push_back(NodeOf(node.First, low));
      nodes.push_back(NodeOf(node.First + low, node.Count - low));
      left.push_back(child);
      left.push_back(child + 1);
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

  // Sets the ball of a node, about the middle of its box, and returns the box's longest side, or -1
  // if it is a point.
  int Enclose(ChargeNode& node)
  {
    const Charge* charges = this->Charges.data() + node.First;
    double low[3];
    double high[3];
    std::copy_n(charges[0].X, 3, low);
    std::copy_n(charges[0].X, 3, high);
    for (std::int32_t i = 0; i < node.Count; ++i)
    {
      for (int axis = 0; axis < 3; ++axis)
      {
        low[axis] = std::min(low[axis], charges[i].X[axis]);
        high[axis] = std::max(high[axis], charges[i].X[axis]);
      }
      node.MostRadius = std::max(node.MostRadius, charges[i].Radius);
      node.MostStrength = std::max(node.MostStrength, charges[i].Strength);
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
        const double away = charges[i].X[axis] - node.Center[axis];
        distance += away * away;
      }
      square = std::max(square, distance);
      static_assert(MeanPower == 16, "as it is computed here");
      double power = distance * inverse; // at most 1: high powers of lengths leave a double's range
      power *= power;
      power *= power;
      weights += charges[i].Strength;
      powers += charges[i].Strength * power * power;
    }
    node.Radius = std::sqrt(square);
    // Rounding makes it no larger than that.
    const double mean = std::sqrt(diagonal) * std::pow(powers / weights, 1.0 / MeanPower);
    node.MeanRadius = std::min(node.Radius, mean * (1.0 + 1e-9));
    this->Middle = node.Center[longest];
    return high[longest] > low[longest] ? longest : -1;
  }

  // How many charges go to the lower half: those below the middle, unless these or the others are
  // so few that the tree would become deep.
  std::int32_t Split(const ChargeNode& node, int axis)
  {
    Charge* first = this->Charges.data() + node.First;
    Charge* last = first + node.Count;
    const double middle = this->Middle;
    Charge* cut =
      std::partition(first, last, [&](const Charge& charge) { return charge.X[axis] < middle; });
    const auto below = static_cast<std::int32_t>(cut - first);
    const std::int32_t few = node.Count / 16;
    if (below > few && node.Count - below > few)
    {
      return below;
    }
    cut = first + node.Count / 2;
    std::nth_element(first, cut, last,
      [axis](const Charge& one, const Charge& other) { return one.X[axis] < other.X[axis]; });
    return node.Count / 2;
  }

  std::vector<Charge>& Charges;
  const std::int32_t Leaf;
  double Middle = 0.0;
};

// Splits the leaves of a tree on, until they have no more than `most` charges.
void SplitLeaves(ChargeTree& tree, std::int32_t most, const ParallelFor& parallelFor)
{
  std::vector<std::int32_t> roots;
  for (std::size_t i = 0; i < tree.Nodes.size(); ++i)
  {
    if (tree.Nodes[i].Child < 0 && tree.Nodes[i].Count > most)
    {
      roots.push_back(static_cast<std::int32_t>(i));
    }
  }
  std::vector<std::vector<ChargeNode>> parts(roots.size());
  parallelFor(static_cast<std::int64_t>(roots.size()),
    [&](std::int64_t i)
    {
      const ChargeNode& root = tree.Nodes[roots[i]];
      parts[i] = Builder(tree.Charges, most).Run(root.First, root.Count);
    });
  for (std::size_t i = 0; i < roots.size(); ++i)
  {
    // The part's root is there already; its children come first.
    const auto shift = static_cast<std::int32_t>(tree.Nodes.size()) - 1;
    for (ChargeNode& node : parts[i])
    {
      node.Child += node.Child < 0 ? 0 : shift;
    }
    tree.Nodes[roots[i]].Child = parts[i].front().Child;
    tree.Nodes.insert(tree.Nodes.end(), parts[i].begin() + 1, parts[i].end());
  }
}
}

//------------------------------------------------------------------------------
ChargeTree BuildChargeTree(
  std::vector<Charge>&& charges, std::int32_t leaf, const ParallelFor& parallelFor)
{
  ChargeTree tree;
  tree.Charges = std::move(charges);
  if (tree.Charges.empty())
  {
    return tree;
  }
  // The first few splits leave too few parts for all threads; the later ones are little work each.
  const auto count = static_cast<std::int32_t>(tree.Charges.size());
  tree.Nodes = Builder(tree.Charges, std::max(leaf, count / 4)).Run(0, count);
  for (std::int32_t part = count / 4; part > leaf;)
  {
    part = part > 16384 ? part / 4 : leaf;
    SplitLeaves(tree, part, parallelFor);
  }
  return tree;
}
}
