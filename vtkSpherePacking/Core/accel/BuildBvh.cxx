// SPDX-License-Identifier: BSD-3-Clause
#include "accel/BuildBvh.h"

#include "accel/BuildSpheres.h"

namespace spherepacking
{
namespace
{
constexpr std::int64_t LeafSize = BvhLeaf::Width;

// Below so many spheres a thread builds the whole subtree.
constexpr std::int64_t SubtreeSize = 1 << 14;

// Spheres at distances that grow exponentially make a hierarchy as deep as they are many. From this
// depth on ranges are halved by number, so that no more than ten levels follow.
constexpr int MaximumSplitDepth = 40;

struct NodeRanges
{
  BuildRange Ranges[BvhNode::Width];
  int Number = 0;
};

// Collapses a binary tree to one of width eight: splits the child with the largest surface until
// there are eight, or only leaves (Wald, Benthin and Boulos, "Getting Rid of Packets", 2008).
NodeRanges ChildrenOf(BuildSpheres& build, const BuildRange& range, int depth)
{
  NodeRanges children;
  children.Ranges[children.Number++] = range;
  while (children.Number < BvhNode::Width)
  {
    int largest = -1;
    float area = -1.0f;
    for (int i = 0; i < children.Number; ++i)
    {
      const BuildRange& child = children.Ranges[i];
      if (child.Count > LeafSize && child.Box.HalfArea() > area)
      {
        largest = i;
        area = child.Box.HalfArea();
      }
    }
    if (largest < 0)
    {
      break;
    }
    const auto sides = depth < MaximumSplitDepth ? build.Split(children.Ranges[largest])
                                                 : build.Halve(children.Ranges[largest]);
    children.Ranges[largest] = sides.first;
    children.Ranges[children.Number++] = sides.second;
  }
  return children;
}

void SetBox(BvhNode& node, int child, const FloatBox& box)
{
  for (int axis = 0; axis < 3; ++axis)
  {
    node.Low[axis][child] = box.Low(axis);
    node.High[axis][child] = box.High(axis);
  }
}

std::uint32_t AddLeaf(const SphereArrays& spheres, bool exact, const BuildSpheres& build,
  const BuildRange& range, std::vector<BvhLeaf>& leaves)
{
  BvhLeaf leaf;
  for (int i = 0; i < BvhLeaf::Width; ++i)
  {
    const bool there = i < range.Count;
    const std::int64_t at = range.First + (there ? i : 0);
    BuildSphere sphere = build.Spheres[at];
    if (exact)
    {
      const Sphere own = spheres[build.Ids[at]];
      sphere = { { static_cast<float>(own.X), static_cast<float>(own.Y),
                   static_cast<float>(own.Z) },
        static_cast<float>(own.R) };
    }
    for (int axis = 0; axis < 3; ++axis)
    {
      leaf.Center[axis][i] = sphere.X[axis];
    }
    leaf.Radius[i] = there ? sphere.R : FloatBox::Empty;
    leaf.Ids[i] = there ? build.Ids[at] : -1;
  }
  leaves.push_back(leaf);
  return static_cast<std::uint32_t>(leaves.size() - 1) | BvhChild::LeafBit;
}

// A subtree that another task builds.
struct Subtree
{
  std::uint32_t Node;
  int Child;
  int Depth;
  BuildRange Range;
};

// A part of the hierarchy, whose children are counted from its own first node and leaf.
struct Part
{
  std::vector<BvhNode> Nodes;
  std::vector<BvhLeaf> Leaves;
  std::vector<Subtree> Subtrees;
  const SphereArrays* Spheres;
  bool Exact;

  // Adds the subtree of a range. Ranges of at most `deferred` spheres become subtrees for others.
  void Add(BuildSpheres& build, const BuildRange& range, std::int64_t deferred, int depth)
  {
    const NodeRanges children = ChildrenOf(build, range, depth);
    this->PrefetchLeaves(build, children);
    const std::uint32_t index = static_cast<std::uint32_t>(this->Nodes.size());
    this->Nodes.emplace_back();
    for (int i = 0; i < BvhNode::Width; ++i)
    {
      const BuildRange& child = children.Ranges[i];
      SetBox(this->Nodes[index], i, child.Box);
      this->Nodes[index].Children[i] = 0;
      if (child.Count == 0)
      {
        continue;
      }
      if (child.Count <= LeafSize)
      {
        this->Nodes[index].Children[i] =
          AddLeaf(*this->Spheres, this->Exact, build, child, this->Leaves);
      }
      else if (child.Count <= deferred)
      {
        this->Subtrees.push_back({ index, i, depth + 1, child });
      }
      else
      {
        this->Nodes[index].Children[i] = static_cast<std::uint32_t>(this->Nodes.size());
        this->Add(build, child, deferred, depth + 1);
      }
    }
  }

private:
  // Neighbours in a leaf are far apart in the packing's arrays.
  void PrefetchLeaves(const BuildSpheres& build, const NodeRanges& children) const
  {
    for (const BuildRange& child : children.Ranges)
    {
      for (std::int64_t i = 0; this->Exact && child.Count <= LeafSize && i < child.Count; ++i)
      {
        this->Spheres->Prefetch(build.Ids[child.First + i]);
      }
    }
  }
};

// Copies a part to its nodes and leaves among all.
void CopyPart(const Part& part, std::uint32_t node, std::uint32_t leaf, Bvh& bvh)
{
  for (std::size_t i = 0; i < part.Nodes.size(); ++i)
  {
    BvhNode& copy = bvh.Nodes[node + i];
    copy = part.Nodes[i];
    for (std::uint32_t& child : copy.Children)
    {
      child += BvhChild::IsLeaf(child) ? leaf : child == 0 ? 0 : node;
    }
  }
  std::copy(part.Leaves.begin(), part.Leaves.end(), bvh.Leaves.data() + leaf);
}

// Puts all parts, of which the first refers to the others, into one hierarchy.
void Join(std::vector<Part>& parts, const ParallelFor& parallelFor, Bvh& bvh)
{
  std::vector<std::uint32_t> nodes(1, 0);
  std::vector<std::uint32_t> leaves(1, 0);
  for (const Part& part : parts)
  {
    nodes.push_back(nodes.back() + static_cast<std::uint32_t>(part.Nodes.size()));
    leaves.push_back(leaves.back() + static_cast<std::uint32_t>(part.Leaves.size()));
  }
  for (std::size_t i = 1; i < parts.size(); ++i)
  {
    const Subtree& subtree = parts[0].Subtrees[i - 1];
    parts[0].Nodes[subtree.Node].Children[subtree.Child] = nodes[i];
  }
  bvh.Nodes = HugeArray<BvhNode>(nodes.back());
  bvh.Leaves = HugeArray<BvhLeaf>(leaves.back());
  parallelFor(static_cast<std::int64_t>(parts.size()),
    [&](std::int64_t i)
    {
      CopyPart(parts[i], nodes[i], leaves[i], bvh);
      parts[i].Nodes = {};
      parts[i].Leaves = {};
    });
}
}

//------------------------------------------------------------------------------
Bvh BuildBvh(const SphereArrays& spheres, const ParallelFor& parallelFor)
{
  BuildSpheres build(spheres, 0.0, parallelFor);
  Bvh bvh;
  std::copy(build.Center, build.Center + 3, bvh.Center);
  bvh.Scale = build.Scale;
  const float leafScale = static_cast<float>(build.Scale);
  bvh.Exact = spheres.Single() && leafScale > 1e-30f && leafScale < 1e30f;
  bvh.LeafScale = bvh.Exact ? leafScale : 1.0f;
  for (int axis = 0; axis < 3; ++axis)
  {
    bvh.LeafCenter[axis] = bvh.Exact ? static_cast<float>(build.Center[axis]) : 0.0f;
  }
  const BuildRange all = build.All();
  if (all.Count == 0)
  {
    return bvh;
  }
  Part empty;
  empty.Spheres = &spheres;
  empty.Exact = bvh.Exact;
  std::vector<Part> parts(1, empty);
  parts[0].Add(build, all, SubtreeSize, 0);
  parts.resize(1 + parts[0].Subtrees.size(), empty);
  parallelFor(static_cast<std::int64_t>(parts[0].Subtrees.size()),
    [&](std::int64_t i)
    {
      const Subtree& subtree = parts[0].Subtrees[i];
      parts[i + 1].Leaves.reserve(subtree.Range.Count / 5);
      parts[i + 1].Nodes.reserve(subtree.Range.Count / 16);
      parts[i + 1].Add(build, subtree.Range, 0, subtree.Depth);
    });
  Join(parts, parallelFor, bvh);
  return bvh;
}
}
