// SPDX-License-Identifier: BSD-3-Clause
#include "accel/BoxTree.h"

#include "accel/BuildSpheres.h"

#include <limits>
#include <queue>

namespace spherepacking
{
namespace
{
using Sides = std::pair<BuildRange, BuildRange>;

// A node in the order in which they come up; its children are neighbours.
struct Branch
{
  BuildRange Range;
  int Depth = 0;
  std::int64_t Children = 0; // index of the first; 0 for none
};

struct Candidate
{
  double Gain;
  std::int64_t Index;
  Sides Halves;

  bool operator<(const Candidate& other) const
  {
    return this->Gain != other.Gain ? this->Gain < other.Gain : this->Index > other.Index;
  }
};

class Builder
{
public:
  Builder(const SphereArrays& spheres, const ParallelFor& parallelFor)
    : Build(spheres, -1.0, parallelFor)
    , Spheres(spheres)
    , For(parallelFor)
  {
    const BuildRange all = this->Build.All();
    if (all.Count > 0)
    {
      this->Branches.push_back({ all });
    }
  }

  void SplitToLeaves(std::int64_t leaves)
  {
    std::priority_queue<Candidate> candidates;
    if (leaves > 1 && !this->Branches.empty())
    {
      this->Consider(candidates, 0);
    }
    for (std::int64_t found = 1; found < leaves && !candidates.empty(); ++found)
    {
      const Candidate best = candidates.top();
      candidates.pop();
      const std::int64_t children = this->Add(best.Index, best.Halves);
      if (found + 1 < leaves)
      {
        this->Consider(candidates, children);
        this->Consider(candidates, children + 1);
      }
    }
  }

  void SplitToDepth(int depth)
  {
    for (std::size_t i = 0; i < this->Branches.size(); ++i)
    {
      const Branch& branch = this->Branches[i];
      if (branch.Depth < depth && branch.Range.Count > 1)
      {
        this->Add(static_cast<std::int64_t>(i), this->Build.Split(branch.Range));
      }
    }
  }

  BoxTree Finish()
  {
    BoxTree tree;
    this->Number(tree.Nodes);
    tree.Ids = std::move(this->Build.Ids);
    this->Bound(tree);
    return tree;
  }

private:
  void Consider(std::priority_queue<Candidate>& candidates, std::int64_t index)
  {
    const BuildRange range = this->Branches[index].Range;
    if (range.Count > 1)
    {
      const Sides sides = this->Build.Split(range);
      const auto cost = [](const BuildRange& side, int visits)
      { return side.Box.HalfArea() * static_cast<double>(side.Count + visits); };
      // The visit of the node itself stays.
      const double gain = cost(range, 0) - cost(sides.first, 1) - cost(sides.second, 1);
      candidates.push({ gain, index, sides });
    }
  }

  std::int64_t Add(std::int64_t parent, const Sides& sides)
  {
    const std::int64_t children = static_cast<std::int64_t>(this->Branches.size());
    const int depth = this->Branches[parent].Depth + 1;
    this->Branches[parent].Children = children;
    this->Branches.push_back({ sides.first, depth });
    this->Branches.push_back({ sides.second, depth });
    return children;
  }

  // Without recursion, because spheres at distances that grow exponentially make a deep tree.
  void Number(std::vector<BoxNode>& nodes)
  {
    struct Pending
    {
      std::int64_t Branch;
      std::int64_t Parent; // whose second child it is; -1 for none
    };
    nodes.reserve(this->Branches.size());
    std::vector<Pending> stack;
    if (!this->Branches.empty())
    {
      stack.push_back({ 0, -1 });
    }
    while (!stack.empty())
    {
      const Pending next = stack.back();
      stack.pop_back();
      const Branch& branch = this->Branches[next.Branch];
      const std::int64_t index = static_cast<std::int64_t>(nodes.size());
      if (next.Parent >= 0)
      {
        nodes[next.Parent].Second = index;
      }
      nodes.push_back({ {}, branch.Range.First, branch.Range.Count, 0, branch.Depth });
      if (branch.Children)
      {
        stack.push_back({ branch.Children + 1, index });
        stack.push_back({ branch.Children, -1 });
      }
    }
  }

  // The builder's boxes are single precision and larger than the spheres.
  void Bound(BoxTree& tree) const
  {
    constexpr std::int64_t chunk = 64;
    const std::int64_t count = static_cast<std::int64_t>(tree.Nodes.size());
    this->For((count + chunk - 1) / chunk,
      [&](std::int64_t i)
      {
        for (std::int64_t at = i * chunk; at < std::min((i + 1) * chunk, count); ++at)
        {
          BoxNode& node = tree.Nodes[at];
          if (node.IsLeaf())
          {
            node.Bounds = this->BoundsOf(tree.Ids.data() + node.First, node.Count);
          }
        }
      });
    for (std::int64_t at = count - 1; at >= 0; --at)
    {
      BoxNode& node = tree.Nodes[at];
      if (!node.IsLeaf())
      {
        const Box& first = tree.Nodes[at + 1].Bounds;
        const Box& second = tree.Nodes[node.Second].Bounds;
        for (int axis = 0; axis < 3; ++axis)
        {
          node.Bounds.Low[axis] = std::min(first.Low[axis], second.Low[axis]);
          node.Bounds.High[axis] = std::max(first.High[axis], second.High[axis]);
        }
      }
    }
  }

  Box BoundsOf(const std::int32_t* ids, std::int64_t count) const
  {
    constexpr double big = std::numeric_limits<double>::max();
    Box box{ { big, big, big }, { -big, -big, -big } };
    for (std::int64_t i = 0; i < count; ++i)
    {
      const Sphere sphere = this->Spheres[ids[i]];
      const double center[3] = { sphere.X, sphere.Y, sphere.Z };
      for (int axis = 0; axis < 3; ++axis)
      {
        box.Low[axis] = std::min(box.Low[axis], center[axis] - sphere.R);
        box.High[axis] = std::max(box.High[axis], center[axis] + sphere.R);
      }
    }
    return box;
  }

  BuildSpheres Build;
  const SphereArrays& Spheres;
  const ParallelFor& For;
  std::vector<Branch> Branches;
};

// In units of the root's longest edge, so that products of lengths stay in the range of double.
double HalfArea(const Box& box, double unit)
{
  double size[3];
  for (int axis = 0; axis < 3; ++axis)
  {
    size[axis] = (box.High[axis] - box.Low[axis]) / unit;
  }
  return size[0] * size[1] + size[1] * size[2] + size[2] * size[0];
}
}

//------------------------------------------------------------------------------
double BoxTree::SahCost() const
{
  if (this->Nodes.empty())
  {
    return 0.0;
  }
  const Box& root = this->Nodes.front().Bounds;
  double unit = 0.0;
  for (int axis = 0; axis < 3; ++axis)
  {
    unit = std::max(unit, root.High[axis] - root.Low[axis]);
  }
  const double all = unit > 0.0 ? HalfArea(root, unit) : 0.0;
  if (!(all > 0.0))
  {
    return 0.0;
  }
  double cost = 0.0;
  for (const BoxNode& node : this->Nodes)
  {
    const double tests = 1.0 + (node.IsLeaf() ? static_cast<double>(node.Count) : 0.0);
    cost += HalfArea(node.Bounds, unit) / all * tests;
  }
  return cost;
}

//------------------------------------------------------------------------------
double BoxTree::OccupiedFraction() const
{
  double sum = 0.0;
  for (const BoxNode& node : this->Nodes)
  {
    double fraction = node.IsLeaf() ? 1.0 : 0.0;
    for (int axis = 0; axis < 3; ++axis)
    {
      const Box& root = this->Nodes.front().Bounds;
      const double size = root.High[axis] - root.Low[axis];
      fraction *= size > 0.0 ? (node.Bounds.High[axis] - node.Bounds.Low[axis]) / size : 0.0;
    }
    sum += fraction;
  }
  return sum;
}

//------------------------------------------------------------------------------
BoxTree BuildBoxTreeOfLeaves(
  const SphereArrays& spheres, std::int64_t leaves, const ParallelFor& parallelFor)
{
  Builder builder(spheres, parallelFor);
  builder.SplitToLeaves(leaves);
  return builder.Finish();
}

//------------------------------------------------------------------------------
BoxTree BuildBoxTreeOfDepth(const SphereArrays& spheres, int depth, const ParallelFor& parallelFor)
{
  Builder builder(spheres, parallelFor);
  builder.SplitToDepth(depth);
  return builder.Finish();
}
}
