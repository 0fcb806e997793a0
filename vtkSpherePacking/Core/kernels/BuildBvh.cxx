// SPDX-License-Identifier: BSD-3-Clause
#include "kernels/BuildBvh.h"

#include "io/HugePages.h"

#include "kernels/BuildSpheres.h"

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

// Splits the child with the largest surface until there are eight, or only leaves.
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

// A child of a node that is still to be built.
struct Rest
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
  std::vector<Rest> Rests;
  const SphereArrays* Spheres;
  bool Exact;

  // Adds a node for the range and below it all that is needed, but for what is small enough to be
  // left to others.
  void Add(BuildSpheres& build, const BuildRange& range, std::int64_t leave, int depth)
  {
    const NodeRanges children = ChildrenOf(build, range, depth);
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
      else if (child.Count <= leave)
      {
        this->Rests.push_back({ index, i, depth + 1, child });
      }
      else
      {
        this->Nodes[index].Children[i] = static_cast<std::uint32_t>(this->Nodes.size());
        this->Add(build, child, leave, depth + 1);
      }
    }
  }
};

// Puts a part in the place that was left for it.
void Append(Bvh& bvh, const Rest& rest, const Part& part)
{
  const std::uint32_t nodes = static_cast<std::uint32_t>(bvh.Nodes.size());
  const std::uint32_t leaves = static_cast<std::uint32_t>(bvh.Leaves.size());
  bvh.Nodes[rest.Node].Children[rest.Child] = nodes;
  for (BvhNode node : part.Nodes)
  {
    for (std::uint32_t& child : node.Children)
    {
      child += BvhChild::IsLeaf(child) ? leaves : child == 0 ? 0 : nodes;
    }
    bvh.Nodes.push_back(node);
  }
  bvh.Leaves.insert(bvh.Leaves.end(), part.Leaves.begin(), part.Leaves.end());
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
  Part top;
  top.Spheres = &spheres;
  top.Exact = bvh.Exact;
  top.Add(build, all, SubtreeSize, 0);
  Part none;
  none.Spheres = &spheres;
  none.Exact = bvh.Exact;
  std::vector<Part> parts(top.Rests.size(), none);
  parallelFor(static_cast<std::int64_t>(parts.size()),
    [&](std::int64_t i) { parts[i].Add(build, top.Rests[i].Range, 0, top.Rests[i].Depth); });
  std::size_t nodes = top.Nodes.size();
  std::size_t leaves = top.Leaves.size();
  for (const Part& part : parts)
  {
    nodes += part.Nodes.size();
    leaves += part.Leaves.size();
  }
  bvh.Nodes.reserve(nodes);
  bvh.Leaves.reserve(leaves);
  AdviseHugePages(bvh.Nodes.data(), nodes * sizeof(BvhNode));
  AdviseHugePages(bvh.Leaves.data(), leaves * sizeof(BvhLeaf));
  bvh.Nodes = top.Nodes;
  bvh.Leaves = top.Leaves;
  for (std::size_t i = 0; i < parts.size(); ++i)
  {
    Append(bvh, top.Rests[i], parts[i]);
    parts[i] = none;
  }
  return bvh;
}
}
