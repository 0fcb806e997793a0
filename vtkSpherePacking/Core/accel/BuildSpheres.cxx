// SPDX-License-Identifier: BSD-3-Clause
#include "accel/BuildSpheres.h"

#include <cmath>

namespace spherepacking
{
namespace
{
constexpr std::int64_t Chunk = 1 << 16;

// Coordinates up to 1, radii up to 1, each rounded once, and their sum once more.
constexpr float RoundingOfBoxes = 4.0f / (1 << 24);

std::int64_t ChunksOf(std::int64_t count)
{
  return (count + Chunk - 1) / Chunk;
}
}

//------------------------------------------------------------------------------
BuildSpheres::BuildSpheres(
  const SphereArrays& spheres, double least, const ParallelFor& parallelFor)
  : For(parallelFor)
{
  this->FindBounds(spheres);
  this->Ids = HugeArray<std::int32_t>(spheres.Count);
  this->Count = 0;
  for (std::int64_t i = 0; i < spheres.Count; ++i)
  {
    this->Ids[this->Count] = static_cast<std::int32_t>(i);
    this->Count += spheres[i].R > least;
  }
  this->Spheres = HugeArray<BuildSphere>(this->Count);
  this->ScratchSpheres = HugeArray<BuildSphere>(this->Count);
  this->ScratchIds = HugeArray<std::int32_t>(this->Count);
  this->For(ChunksOf(this->Count),
    [&](std::int64_t chunk)
    {
      for (std::int64_t i = chunk * Chunk; i < std::min((chunk + 1) * Chunk, this->Count); ++i)
      {
        const Sphere sphere = spheres[this->Ids[i]];
        this->Spheres[i] = { { static_cast<float>((sphere.X - this->Center[0]) * this->Scale),
                               static_cast<float>((sphere.Y - this->Center[1]) * this->Scale),
                               static_cast<float>((sphere.Z - this->Center[2]) * this->Scale) },
          static_cast<float>(sphere.R * this->Scale) + RoundingOfBoxes };
      }
    });
}

//------------------------------------------------------------------------------
void BuildSpheres::FindBounds(const SphereArrays& spheres)
{
  const std::int64_t chunks = ChunksOf(spheres.Count);
  constexpr double big = std::numeric_limits<double>::max();
  struct Ends
  {
    double Values[6] = { -big, -big, -big, -big, -big, -big };
  };
  std::vector<Ends> parts(chunks);
  this->For(chunks,
    [&](std::int64_t chunk)
    {
      Ends ends;
      const std::int64_t end = std::min((chunk + 1) * Chunk, spheres.Count);
      for (std::int64_t i = chunk * Chunk; i < end; ++i)
      {
        const Sphere s = spheres[i];
        const double values[6] = { s.R - s.X, s.R - s.Y, s.R - s.Z, s.R + s.X, s.R + s.Y,
          s.R + s.Z };
        for (int k = 0; k < 6; ++k)
        {
          ends.Values[k] = std::max(ends.Values[k], values[k]);
        }
      }
      parts[chunk] = ends;
    });
  Ends all;
  for (const Ends& part : parts)
  {
    for (int k = 0; k < 6; ++k)
    {
      all.Values[k] = std::max(all.Values[k], part.Values[k]);
    }
  }
  double reach = 0.0;
  for (int axis = 0; axis < 3; ++axis)
  {
    const double low = -all.Values[axis];
    const double high = all.Values[3 + axis];
    const double middle = spheres.Count == 0 ? 0.0 : low + 0.5 * (high - low);
    this->Center[axis] = spheres.Single() ? static_cast<float>(middle) : middle;
    reach = spheres.Count == 0
      ? 0.0
      : std::max({ reach, high - this->Center[axis], this->Center[axis] - low });
  }
  // The inverse of a denormal number may be infinite.
  this->Scale = reach >= std::numeric_limits<double>::min()
    ? std::ldexp(1.0, -static_cast<int>(std::ceil(std::log2(reach))))
    : 1.0;
}

//------------------------------------------------------------------------------
BuildRange BuildSpheres::All() const
{
  BuildRange range;
  range.Count = this->Count;
  std::vector<BuildRange> parts(ChunksOf(range.Count));
  this->For(static_cast<std::int64_t>(parts.size()),
    [&](std::int64_t chunk)
    {
      BuildRange part;
      const std::int64_t end = std::min((chunk + 1) * Chunk, range.Count);
      for (std::int64_t i = chunk * Chunk; i < end; ++i)
      {
        part.Box.Add(this->Spheres[i]);
        part.Centers.AddCenter(this->Spheres[i]);
      }
      parts[chunk] = part;
    });
  for (const BuildRange& part : parts)
  {
    range.Box.Add(part.Box);
    range.Centers.Add(part.Centers);
  }
  return range;
}

//------------------------------------------------------------------------------
std::pair<BuildRange, BuildRange> BuildSpheres::Split(const BuildRange& range)
{
  const int bins = SahBins::NumberFor(range.Count);
  const SahBinning binning(range.Centers, bins);
  if (!binning.CanSplit())
  {
    return this->Halve(range);
  }
  const SahSplit split = this->Find(range, binning, bins);
  if (split.Axis < 0)
  {
    return this->Halve(range);
  }
  std::pair<BuildRange, BuildRange> sides;
  FloatBox centers[2];
  const std::int64_t middle = this->Partition(range, binning, split, centers);
  sides.first = { range.First, middle - range.First, split.Boxes[0], centers[0] };
  sides.second = { middle, range.First + range.Count - middle, split.Boxes[1], centers[1] };
  return sides;
}

//------------------------------------------------------------------------------
SahSplit BuildSpheres::Find(const BuildRange& range, const SahBinning& binning, int bins) const
{
  const BuildSphere* first = this->Spheres.data() + range.First;
  SahBins all(bins);
  if (range.Count <= 2 * Chunk)
  {
    binning.Count(first, first + range.Count, all);
    return BestSplit(all);
  }
  // Counts and boxes are the same in whatever order the chunks are added.
  const std::int64_t chunks = ChunksOf(range.Count);
  std::vector<SahBins> parts(chunks, all);
  this->For(chunks,
    [&](std::int64_t chunk)
    {
      binning.Count(
        first + chunk * Chunk, first + std::min((chunk + 1) * Chunk, range.Count), parts[chunk]);
    });
  for (const SahBins& part : parts)
  {
    all.Add(part);
  }
  return BestSplit(all);
}

//------------------------------------------------------------------------------
std::int64_t BuildSpheres::Partition(
  const BuildRange& range, const SahBinning& binning, const SahSplit& split, FloatBox (&centers)[2])
{
  return range.Count <= 2 * Chunk
    ? this->PartitionPart(range.First, range.First + range.Count, binning, split, centers)
    : this->PartitionInParallel(range, binning, split, centers);
}

//------------------------------------------------------------------------------
std::int64_t BuildSpheres::PartitionPart(std::int64_t first, std::int64_t last,
  const SahBinning& binning, const SahSplit& split, FloatBox (&centers)[2])
{
  // Without branches, which could not be predicted: each sphere is written to both sides, and only
  // the end of the side that it belongs to moves on.
  std::int64_t low = first;
  std::int64_t high = first;
  for (std::int64_t i = first; i < last; ++i)
  {
    const BuildSphere sphere = this->Spheres[i];
    const std::int32_t id = this->Ids[i];
    const int side = binning.BinOf(sphere, split.Axis) >= split.Bin;
    this->Spheres[low] = sphere;
    this->Ids[low] = id;
    this->ScratchSpheres[high] = sphere;
    this->ScratchIds[high] = id;
    low += 1 - side;
    high += side;
    centers[side].AddCenter(sphere);
  }
  std::copy(&this->ScratchSpheres[first], &this->ScratchSpheres[first] + (high - first),
    &this->Spheres[low]);
  std::copy(&this->ScratchIds[first], &this->ScratchIds[first] + (high - first), &this->Ids[low]);
  return low;
}

//------------------------------------------------------------------------------
std::int64_t BuildSpheres::PartitionInParallel(
  const BuildRange& range, const SahBinning& binning, const SahSplit& split, FloatBox (&centers)[2])
{
  // Each chunk by itself, then all first and all second sides together.
  struct Part
  {
    std::int64_t First;
    std::int64_t Middle;
    std::int64_t Last;
    FloatBox Centers[2];
    std::int64_t Targets[2];
  };
  std::vector<Part> parts(ChunksOf(range.Count));
  const std::int64_t count = static_cast<std::int64_t>(parts.size());
  this->For(count,
    [&](std::int64_t k)
    {
      Part& part = parts[k];
      part.First = range.First + k * Chunk;
      part.Last = std::min(part.First + Chunk, range.First + range.Count);
      part.Middle = this->PartitionPart(part.First, part.Last, binning, split, part.Centers);
    });
  std::int64_t target = range.First;
  for (Part& part : parts)
  {
    part.Targets[0] = target;
    target += part.Middle - part.First;
    centers[0].Add(part.Centers[0]);
    centers[1].Add(part.Centers[1]);
  }
  const std::int64_t middle = target;
  for (Part& part : parts)
  {
    part.Targets[1] = target;
    target += part.Last - part.Middle;
  }
  const auto move =
    [](const auto& from, std::int64_t first, std::int64_t last, auto& to, std::int64_t at)
  { std::copy(from.data() + first, from.data() + last, to.data() + at); };
  this->For(count,
    [&](std::int64_t k)
    {
      const Part& part = parts[k];
      move(this->Spheres, part.First, part.Middle, this->ScratchSpheres, part.Targets[0]);
      move(this->Spheres, part.Middle, part.Last, this->ScratchSpheres, part.Targets[1]);
      move(this->Ids, part.First, part.Middle, this->ScratchIds, part.Targets[0]);
      move(this->Ids, part.Middle, part.Last, this->ScratchIds, part.Targets[1]);
    });
  this->For(count,
    [&](std::int64_t k)
    {
      const Part& part = parts[k];
      move(this->ScratchSpheres, part.First, part.Last, this->Spheres, part.First);
      move(this->ScratchIds, part.First, part.Last, this->Ids, part.First);
    });
  return middle;
}

//------------------------------------------------------------------------------
std::pair<BuildRange, BuildRange> BuildSpheres::Halve(const BuildRange& range) const
{
  BuildRange sides[2];
  sides[0].First = range.First;
  sides[0].Count = range.Count / 2;
  sides[1].First = range.First + sides[0].Count;
  sides[1].Count = range.Count - sides[0].Count;
  for (BuildRange& side : sides)
  {
    for (std::int64_t i = side.First; i < side.First + side.Count; ++i)
    {
      side.Box.Add(this->Spheres[i]);
      side.Centers.AddCenter(this->Spheres[i]);
    }
  }
  return { sides[0], sides[1] };
}
}
