// SPDX-License-Identifier: BSD-3-Clause
#include "metaballs/Charges.h"

#include "metaballs/TruncationError.h"

#include <algorithm>
#include <cmath>

namespace spherepacking
{
namespace
{
class Builder
{
public:
  Builder(ChargeTree& tree, int leaf)
    : Tree(tree)
    , Leaf(leaf)
  {
  }

  // Depth first, with a list instead of a recursion: trees may be deep.
  void Run()
  {
    ChargeNode root;
    root.Count = static_cast<std::int32_t>(this->Tree.Charges.size());
    this->Tree.Nodes.push_back(root);
    std::vector<std::int32_t> left{ 0 };
    while (!left.empty())
    {
      const std::int32_t at = left.back();
      left.pop_back();
      const int axis = this->Enclose(this->Tree.Nodes[at]);
      const ChargeNode node = this->Tree.Nodes[at];
      if (node.Count <= this->Leaf || axis < 0)
      {
        continue;
      }
      const std::int32_t first = this->Split(node, axis);
      const auto child = static_cast<std::int32_t>(this->Tree.Nodes.size());
      this->Tree.Nodes[at].Child = child;
      ChargeNode low;
      low.First = node.First;
      low.Count = first;
      ChargeNode high;
      high.First = node.First + first;
      high.Count = node.Count - first;
      this->Tree.Nodes.push_back(low);
      this->Tree.Nodes.push_back(high);
      left.push_back(child);
      left.push_back(child + 1);
    }
  }

private:
  // Sets the ball of a node, about the middle of its box, and returns the box's longest side, or -1
  // if it is a point.
  int Enclose(ChargeNode& node)
  {
    const Charge* charges = this->Tree.Charges.data() + node.First;
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
    for (int axis = 0; axis < 3; ++axis)
    {
      node.Center[axis] = 0.5 * (low[axis] + high[axis]);
      longest = high[axis] - low[axis] > high[longest] - low[longest] ? axis : longest;
    }
    double square = 0.0;
    double weights = 0.0;
    double powers = 0.0;
    for (std::int32_t i = 0; i < node.Count; ++i)
    {
      double distance = 0.0;
      for (int axis = 0; axis < 3; ++axis)
      {
        const double away = charges[i].X[axis] - node.Center[axis];
        distance += away * away;
      }
      square = std::max(square, distance);
      static_assert(MeanPower == 10, "as it is computed here");
      weights += charges[i].Strength;
      powers += charges[i].Strength * (distance * distance) * (distance * distance) * distance;
    }
    node.Radius = std::sqrt(square);
    // Rounding, and lengths whose powers are too small for a double, make it no larger than that.
    node.MeanRadius =
      std::min(node.Radius, std::pow(powers / weights, 1.0 / MeanPower) * (1.0 + 1e-9));
    this->Middle = node.Center[longest];
    return high[longest] > low[longest] ? longest : -1;
  }

  // How many charges go to the lower half: those below the middle, unless these or the others are
  // so few that the tree would become deep.
  std::int32_t Split(const ChargeNode& node, int axis)
  {
    Charge* first = this->Tree.Charges.data() + node.First;
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

  ChargeTree& Tree;
  const std::int32_t Leaf;
  double Middle = 0.0;
};
}

//------------------------------------------------------------------------------
ChargeTree BuildChargeTree(std::vector<Charge>&& charges, int leaf)
{
  ChargeTree tree;
  tree.Charges = std::move(charges);
  if (!tree.Charges.empty())
  {
    Builder(tree, leaf).Run();
  }
  return tree;
}
}
