// SPDX-License-Identifier: BSD-3-Clause
#include "packer/PackSpheres.h"

#include "packer/Ascend.h"
#include "packer/TouchingBall.h"

#include <algorithm>
#include <cmath>
#include <queue>
#include <random>
#include <tuple>

namespace spherepacking
{
namespace
{
// A leaf is searched for a maximum when its diagonal is no longer than this part of its bound.
constexpr double Small = 0.5;
constexpr std::size_t MostLeaves = 256; // of a round
constexpr int Patience = 100;           // rounds without a sphere
constexpr int MostPatience = 2000;      // in thin sheets leaves have no end
// Keeps spheres apart by more than rounding.
constexpr double Shrink = 1.0 - 1e-9;

// Of leaves whose bounds are nearly equal, the smallest come first: one of them will do.
struct Entry
{
  std::int16_t Band; // of bounds
  std::int16_t Depth;
  std::int32_t Leaf;
  std::uint32_t Birth;

  bool operator<(const Entry& other) const
  {
    return std::tie(this->Band, this->Depth, other.Leaf) <
      std::tie(other.Band, other.Depth, this->Leaf);
  }
};

// What becomes of a leaf in a round.
struct Task
{
  std::int32_t Leaf;
  bool Climbs;
  bool FromSurface; // and not from its middle, which may be outside
  double Enough;    // radius that a sphere must have: that of the leaf's band
  PackedSphere Sphere;
  bool Splits = false;
  ClearanceTree::Eight Children;
};

struct OctreeCube
{
  Vector3 Middle;
  float Half;
};

// Around the mesh, shifted at random.
OctreeCube CubeAround(const SurfaceMesh& mesh, std::uint64_t seed)
{
  const MeshBox box = BoxOf(mesh);
  const double half = 0.5 * box.LongestSide();
  OctreeCube cube{ box.Middle(), static_cast<float>(1.11 * half) };
  std::mt19937_64 random(seed);
  for (int axis = 0; axis < 3; ++axis)
  {
    // Not std::uniform_real_distribution, which differs between libraries.
    const double unit = static_cast<double>(random() >> 11) * 0x1p-53;
    cube.Middle[axis] += 0.2 * half * (unit - 0.5);
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
    , Tree(this->Surface, this->Cube.Middle, this->Cube.Half, goal.LeastRadius)
  {
    this->Push(0);
  }

  std::vector<PackedSphere> Run(const PackingProgress& progress)
  {
    while (!this->IsDone() && this->Stalled < MostPatience && progress(this->Count(), this->Volume))
    {
      this->Choose();
      if (this->Tasks.empty())
      {
        break;
      }
      this->For(static_cast<std::int64_t>(this->Tasks.size()),
        [this](std::int64_t i) { this->Work(this->Tasks[i]); });
      this->Apply();
    }
    std::vector<PackedSphere> spheres = this->Tree.Spheres();
    std::stable_sort(spheres.begin(), spheres.end(),
      [](const PackedSphere& a, const PackedSphere& b) { return a.Radius > b.Radius; });
    return spheres;
  }

private:
  std::int64_t Count() const { return static_cast<std::int64_t>(this->Tree.Spheres().size()); }

  std::int16_t BandOf(double bound) const
  {
    return static_cast<std::int16_t>(std::ceil(std::log(bound) / this->Band));
  }
  double TopOf(int band) const { return std::exp(band * this->Band); }

  bool IsDone() const
  {
    return this->Count() >= this->Goal.Count || this->Volume >= this->Goal.Volume;
  }

  void Push(std::int32_t leaf)
  {
    const ClearanceTree::Cell& cell = this->Tree[leaf];
    if (!cell.Dead)
    {
      const auto depth =
        static_cast<std::int16_t>(std::lround(std::log2(this->Cube.Half / cell.Half)));
      this->Queue.push({ this->BandOf(cell.Bound), depth, leaf, cell.Birth });
    }
  }

  // The leaves of the largest bounds. Of those that are to be searched, one near to another would
  // find the same maximum, and waits.
  void Choose()
  {
    this->Tasks.clear();
    this->Waiting.clear();
    std::vector<Vector3> climbers;
    while (!this->Queue.empty() && this->Tasks.size() < MostLeaves)
    {
      const Entry entry = this->Queue.top();
      if (!this->Tasks.empty() &&
        this->TopOf(entry.Band - 1) < (1.0 - this->Tolerance) * this->Most)
      {
        break;
      }
      this->Queue.pop();
      if (!this->Tree.IsLeaf(entry.Leaf, entry.Birth))
      {
        continue;
      }
      this->Tree.Refresh(entry.Leaf);
      const ClearanceTree::Cell& cell = this->Tree[entry.Leaf];
      if (this->BandOf(cell.Bound) < entry.Band)
      {
        this->Push(entry.Leaf); // spheres have come since
        continue;
      }
      if (this->Tasks.empty())
      {
        this->Most = this->TopOf(entry.Band);
      }
      // Of leaves in thin walls the middles lie outside until they are as small. Most others whose
      // middles are outside have nothing to find, so that is tried now and then.
      const bool forced = this->Stalled >= Patience &&
        (cell.Clearance > this->Goal.LeastRadius || this->Stalled % Patience == 0);
      const bool small = cell.Diagonal() < Small * cell.Bound;
      const bool climbs = forced || small;
      if (climbs &&
        std::any_of(climbers.begin(), climbers.end(),
          [&](const Vector3& other) { return Length(other - cell.Middle) < this->Most; }))
      {
        this->Waiting.push_back(entry);
        if (this->Waiting.size() > 8 * MostLeaves)
        {
          break;
        }
        continue;
      }
      if (climbs)
      {
        climbers.push_back(cell.Middle);
      }
      this->Tasks.emplace_back();
      this->Tasks.back().Leaf = entry.Leaf;
      this->Tasks.back().Climbs = climbs;
      this->Tasks.back().FromSurface = !small && !(cell.Clearance > this->Goal.LeastRadius);
      // Of a leaf that is as good as a point, nothing larger can come.
      this->Tasks.back().Enough = std::min(this->TopOf(entry.Band - 1), 0.999 * cell.Bound);
      if (forced)
      {
        this->Tasks.back().Enough = 0.0;
      }
    }
    for (const Entry& entry : this->Waiting)
    {
      this->Queue.push(entry);
    }
  }

  void Work(Task& task) const
  {
    const ClearanceTree::Cell& cell = this->Tree[task.Leaf];
    if (task.Climbs)
    {
      const Vector3 start =
        task.FromSurface ? TouchingBall(this->Surface, cell.Middle, cell.Diagonal()) : cell.Middle;
      task.Sphere = Ascend(this->Tree, start, cell.Diagonal(), task.Enough);
      task.Sphere.Radius *= Shrink;
      if (task.Sphere.Radius > std::max(task.Enough, this->Goal.LeastRadius))
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
    std::stable_sort(spheres.begin(), spheres.end(),
      [](const PackedSphere& a, const PackedSphere& b) { return a.Radius > b.Radius; });
    const std::size_t before = this->Tree.Spheres().size();
    if (before == 0 && !spheres.empty())
    {
      this->Loosen();
    }
    // What was not measured against a band is measured against the best.
    const double least = spheres.empty() ? 0.0 : (1.0 - this->Tolerance) * spheres.front().Radius;
    ++this->Stalled;
    for (const PackedSphere& sphere : spheres)
    {
      if (!this->IsDone() && sphere.Radius >= least && this->IsFree(sphere, before))
      {
        this->Tree.Insert(sphere);
        this->Stalled = 0;
        this->Volume +=
          4.0 / 3.0 * 3.14159265358979323846 * sphere.Radius * sphere.Radius * sphere.Radius;
      }
    }
    for (const Task& task : this->Tasks)
    {
      if (!task.Splits)
      {
        const ClearanceTree::Cell& cell = this->Tree[task.Leaf];
        if (cell.Child < 0)
        {
          this->Push(task.Leaf);
        }
      }
    }
  }

  void Loosen()
  {
    this->Tolerance = 0.35;
    this->Band = 0.2;
    std::priority_queue<Entry> queue;
    queue.swap(this->Queue);
    for (; !queue.empty(); queue.pop())
    {
      if (this->Tree.IsLeaf(queue.top().Leaf, queue.top().Birth))
      {
        this->Push(queue.top().Leaf);
      }
    }
  }

  // Whether it overlaps none of the spheres that have come in this round.
  bool IsFree(const PackedSphere& sphere, std::size_t before) const
  {
    const std::vector<PackedSphere>& spheres = this->Tree.Spheres();
    return std::none_of(spheres.begin() + static_cast<std::ptrdiff_t>(before), spheres.end(),
      [&](const PackedSphere& other)
      { return Length(other.Center - sphere.Center) < other.Radius + sphere.Radius; });
  }

  const TriangleTree Surface;
  const PackingGoal Goal;
  const ParallelFor& For;
  const OctreeCube Cube;
  ClearanceTree Tree;
  std::priority_queue<Entry> Queue;
  std::vector<Task> Tasks;
  std::vector<Entry> Waiting;
  double Most = 0.0; // the largest bound
  double Volume = 0.0;
  int Stalled = 0; // rounds since the last sphere
  // What is tolerated below the largest bound, and by how much the bounds of a band differ. The
  // first sphere is found more exactly.
  double Tolerance = 0.03;
  double Band = 0.02;
};
}

//------------------------------------------------------------------------------
std::vector<PackedSphere> PackSpheres(const SurfaceMesh& mesh, const PackingGoal& goal,
  const ParallelFor& parallelFor, const PackingProgress& progress)
{
  return Packer(mesh, goal, parallelFor).Run(progress);
}
}
