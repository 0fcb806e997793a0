// SPDX-License-Identifier: BSD-3-Clause
#include "packer/PackSpheres.h"

#include "packer/Ascend.h"
#include "packer/ShrinkBall.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <queue>
#include <random>
#include <tuple>

namespace spherepacking
{
namespace
{
// A leaf is small, and climbed from, when half of its diagonal is below this part of its bound.
constexpr double Small = 0.5;
constexpr std::size_t LeavesPerRound = 256;
constexpr std::size_t MaximumDeferred = 8 * LeavesPerRound;
// Rounds without a sphere after which large leaves are climbed from, too, and after which the
// search ends: in sheets without thickness it would find leaves for ever.
constexpr int Patience = 100;
constexpr int MaximumPatience = 2000;
// Leaves a gap between spheres that is larger than rounding.
constexpr double Shrink = 1.0 - 1e-9;

double VolumeOf(const PackedSphere& sphere)
{
  return 4.0 / 3.0 * 3.14159265358979323846 * sphere.Radius * sphere.Radius * sphere.Radius;
}

void SortLargestFirst(std::vector<PackedSphere>& spheres)
{
  std::stable_sort(spheres.begin(), spheres.end(),
    [](const PackedSphere& a, const PackedSphere& b) { return a.Radius > b.Radius; });
}

// A leaf in the queue. Among leaves of one band the smallest come first: they are climbed from, and
// once one of them has led to a sphere, the bounds of the others are lower.
struct QueuedLeaf
{
  std::int16_t Band; // of the bound
  std::int16_t Depth;
  std::int32_t Leaf;
  std::uint32_t Generation;

  bool operator<(const QueuedLeaf& other) const
  {
    return std::tie(this->Band, this->Depth, other.Leaf) <
      std::tie(other.Band, other.Depth, this->Leaf);
  }
};

// What is done to a leaf in a round: it is climbed from or split, and split as well if climbing
// leads to no sphere.
struct Task
{
  std::int32_t Leaf;
  bool Climbs;
  bool FromSurface;      // rather than from its centre, which may be outside
  double RequiredRadius; // what a sphere has to be above: the lower end of the leaf's band
  PackedSphere Sphere;
  bool Splits = false;
  ClearanceTree::Octet Children;
};

struct OctreeCube
{
  Vector3 Center;
  float HalfSide;
};

// Around the mesh, shifted at random.
OctreeCube CubeAround(const SurfaceMesh& mesh, std::uint64_t seed)
{
  const MeshBounds bounds = BoundsOf(mesh);
  const double half = 0.5 * bounds.LongestSide();
  OctreeCube cube{ bounds.Center(), static_cast<float>(1.11 * half) };
  std::mt19937_64 random(seed);
  for (int axis = 0; axis < 3; ++axis)
  {
    // Not std::uniform_real_distribution, which differs between libraries.
    const double unit = static_cast<double>(random() >> 11) * 0x1p-53;
    cube.Center[axis] += 0.2 * half * (unit - 0.5);
  }
  return cube;
}

class Packer
{
public:
  Packer(const SurfaceMesh& mesh, const PackingGoal& goal, const ParallelFor& parallelFor)
    : Surface(mesh)
    , Goal(goal)
    , For(parallelFor)
    , Cube(CubeAround(mesh, goal.Seed))
    , Tree(this->Surface, this->Cube.Center, this->Cube.HalfSide, goal.MinimumRadius)
  {
    this->Push(0);
  }

  std::vector<PackedSphere> Run(const PackingProgress& progress)
  {
    while (
      !this->IsDone() && this->Stalled < MaximumPatience && progress(this->Count(), this->Volume))
    {
      this->ChooseTasks();
      if (this->Tasks.empty())
      {
        break;
      }
      this->For(static_cast<std::int64_t>(this->Tasks.size()),
        [this](std::int64_t i) { this->Work(this->Tasks[i]); });
      this->Apply();
    }
    std::vector<PackedSphere> spheres = this->Tree.Spheres();
    SortLargestFirst(spheres);
    return spheres;
  }

private:
  std::int64_t Count() const { return static_cast<std::int64_t>(this->Tree.Spheres().size()); }

  // Bounds are compared by bands of equal ratio.
  std::int16_t BandOf(double bound) const
  {
    return static_cast<std::int16_t>(std::ceil(std::log(bound) / this->BandWidth));
  }
  double TopOf(int band) const { return std::exp(band * this->BandWidth); }

  bool IsDone() const
  {
    return this->Count() >= this->Goal.Count || this->Volume >= this->Goal.Volume;
  }

  void Push(std::int32_t leaf)
  {
    const ClearanceTree::Cell& cell = this->Tree[leaf];
    if (!cell.Pruned)
    {
      const auto depth =
        static_cast<std::int16_t>(std::lround(std::log2(this->Cube.HalfSide / cell.HalfSide)));
      this->Queue.push({ this->BandOf(cell.Bound), depth, leaf, cell.Generation });
    }
  }

  // Takes the leaves of the highest bounds. A leaf near to one that is climbed from would lead to
  // the same maximum, so it is deferred to the next round.
  void ChooseTasks()
  {
    this->Tasks.clear();
    this->Deferred.clear();
    this->Starts.clear();
    while (this->Tasks.size() < LeavesPerRound && this->Deferred.size() <= MaximumDeferred)
    {
      const std::optional<QueuedLeaf> next = this->NextLeaf();
      if (!next)
      {
        break;
      }
      if (this->Tasks.empty())
      {
        this->HighestBound = this->TopOf(next->Band);
      }
      this->AddTask(*next);
    }
    for (const QueuedLeaf& deferred : this->Deferred)
    {
      this->Queue.push(deferred);
    }
  }

  // Takes the first leaf out of the queue, unless its bound is too low for this round.
  std::optional<QueuedLeaf> NextLeaf()
  {
    while (!this->Queue.empty())
    {
      const QueuedLeaf first = this->Queue.top();
      if (!this->Tasks.empty() &&
        this->TopOf(first.Band - 1) < (1.0 - this->Tolerance) * this->HighestBound)
      {
        return {};
      }
      this->Queue.pop();
      if (!this->Tree.IsLeaf(first.Leaf, first.Generation))
      {
        continue;
      }
      this->Tree.RefreshBound(first.Leaf);
      if (this->BandOf(this->Tree[first.Leaf].Bound) < first.Band)
      {
        this->Push(first.Leaf); // spheres that were inserted since have lowered the bound
        continue;
      }
      return first;
    }
    return {};
  }

  // Whether a leaf is climbed from, however large it is, and any sphere will do. The centres of
  // leaves in thin walls lie outside until the leaves are as small as the wall is thin; most others
  // with a centre outside lead to nothing, so these are tried in one round of many only.
  bool IsForced(const ClearanceTree::Cell& cell) const
  {
    return this->Stalled >= Patience &&
      (this->HasFreeCenter(cell) || this->Stalled % Patience == 0);
  }

  bool HasFreeCenter(const ClearanceTree::Cell& cell) const
  {
    return cell.Clearance > this->Goal.MinimumRadius;
  }

  void AddTask(const QueuedLeaf& leaf)
  {
    const ClearanceTree::Cell& cell = this->Tree[leaf.Leaf];
    const bool forced = this->IsForced(cell);
    const bool small = cell.HalfDiagonal() < Small * cell.Bound;
    const bool climbs = forced || small;
    if (climbs)
    {
      if (this->IsNearStart(cell.Center))
      {
        this->Deferred.push_back(leaf);
        return;
      }
      this->Starts.push_back(cell.Center);
    }
    this->Tasks.emplace_back();
    Task& task = this->Tasks.back();
    task.Leaf = leaf.Leaf;
    task.Climbs = climbs;
    task.FromSurface = !small && !this->HasFreeCenter(cell);
    // A leaf that is as good as a point has nothing above its bound, wherever its band ends.
    task.RequiredRadius = forced ? 0.0 : std::min(this->TopOf(leaf.Band - 1), 0.999 * cell.Bound);
  }

  bool IsNearStart(const Vector3& point) const
  {
    return std::any_of(this->Starts.begin(), this->Starts.end(),
      [&](const Vector3& start) { return Length(start - point) < this->HighestBound; });
  }

  void Work(Task& task) const
  {
    const ClearanceTree::Cell& cell = this->Tree[task.Leaf];
    if (task.Climbs)
    {
      const Vector3 start = task.FromSurface
        ? ShrinkBall(this->Surface, cell.Center, cell.HalfDiagonal())
        : cell.Center;
      task.Sphere = Ascend(this->Tree, start, cell.HalfDiagonal(), task.RequiredRadius);
      task.Sphere.Radius *= Shrink;
      if (task.Sphere.Radius > std::max(task.RequiredRadius, this->Goal.MinimumRadius))
      {
        return;
      }
    }
    task.Splits = true;
    task.Children = this->Tree.Split(task.Leaf);
  }

  void Apply()
  {
    std::vector<PackedSphere> spheres;
    for (Task& task : this->Tasks)
    {
      if (task.Splits)
      {
        const std::int32_t first = this->Tree.Install(task.Leaf, std::move(task.Children));
        for (std::int32_t child = first; child < first + 8; ++child)
        {
          this->Push(child);
        }
      }
      else
      {
        spheres.push_back(task.Sphere);
      }
    }
    SortLargestFirst(spheres);
    this->InsertAll(spheres);
    for (const Task& task : this->Tasks)
    {
      if (!task.Splits && this->Tree[task.Leaf].Child < 0)
      {
        this->Push(task.Leaf);
      }
    }
  }

  // Inserts the spheres that a round has found, but for those that overlap a larger one of them and
  // those, from forced leaves, that are too small beside the largest.
  void InsertAll(const std::vector<PackedSphere>& spheres)
  {
    const std::size_t before = this->Tree.Spheres().size();
    if (before == 0 && !spheres.empty())
    {
      this->LoosenTolerance();
    }
    const double smallest =
      spheres.empty() ? 0.0 : (1.0 - this->Tolerance) * spheres.front().Radius;
    ++this->Stalled;
    for (const PackedSphere& sphere : spheres)
    {
      if (!this->IsDone() && sphere.Radius >= smallest && this->IsFree(sphere, before))
      {
        this->Tree.Insert(sphere);
        this->Stalled = 0;
        this->Volume += VolumeOf(sphere);
      }
    }
  }

  void LoosenTolerance()
  {
    this->Tolerance = 0.35;
    this->BandWidth = 0.2;
    std::priority_queue<QueuedLeaf> queue;
    queue.swap(this->Queue);
    for (; !queue.empty(); queue.pop())
    {
      if (this->Tree.IsLeaf(queue.top().Leaf, queue.top().Generation))
      {
        this->Push(queue.top().Leaf);
      }
    }
  }

  // Whether a sphere overlaps none of those from number `first` on.
  bool IsFree(const PackedSphere& sphere, std::size_t first) const
  {
    const std::vector<PackedSphere>& spheres = this->Tree.Spheres();
    return std::none_of(spheres.begin() + static_cast<std::ptrdiff_t>(first), spheres.end(),
      [&](const PackedSphere& other)
      { return Length(other.Center - sphere.Center) < other.Radius + sphere.Radius; });
  }

  const TriangleTree Surface;
  const PackingGoal Goal;
  const ParallelFor& For;
  const OctreeCube Cube;
  ClearanceTree Tree;
  std::priority_queue<QueuedLeaf> Queue;
  std::vector<Task> Tasks;
  std::vector<QueuedLeaf> Deferred;
  std::vector<Vector3> Starts; // of the leaves that are climbed from in this round
  double HighestBound = 0.0;   // in this round
  double Volume = 0.0;
  int Stalled = 0; // rounds since the last sphere
  // How far a radius may be below the highest bound, as a fraction of it, and the logarithm of the
  // ratio of the bounds of a band. The first sphere, the largest, is found more exactly.
  double Tolerance = 0.03;
  double BandWidth = 0.02;
};
}

//------------------------------------------------------------------------------
std::vector<PackedSphere> PackSpheres(const SurfaceMesh& mesh, const PackingGoal& goal,
  const ParallelFor& parallelFor, const PackingProgress& progress)
{
  return Packer(mesh, goal, parallelFor).Run(progress);
}
}
