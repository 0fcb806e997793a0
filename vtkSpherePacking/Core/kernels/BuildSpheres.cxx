// SPDX-License-Identifier: BSD-3-Clause
#include "kernels/BuildSpheres.h"

#include "io/HugePages.h"

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
  this->Scene(spheres);
  const std::int64_t count = spheres.Count;
  this->Ids.reserve(spheres.Count);
  AdviseHugePages(this->Ids.data(), spheres.Count * sizeof(std::int32_t));
  for (std::int64_t i = 0; i < count; ++i)
  {
    if (spheres[i].R > least)
    {
      this->Ids.push_back(static_cast<std::int32_t>(i));
    }
  }
  this->Spheres.reserve(this->Ids.size());
  AdviseHugePages(this->Spheres.data(), this->Ids.size() * sizeof(BuildSphere));
  this->Spheres.resize(this->Ids.size());
  this->For(ChunksOf(static_cast<std::int64_t>(this->Ids.size())),
    [&](std::int64_t chunk)
    {
      const std::int64_t end =
        std::min((chunk + 1) * Chunk, static_cast<std::int64_t>(this->Ids.size()));
      for (std::int64_t i = chunk * Chunk; i < end; ++i)
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
void BuildSpheres::Scene(const SphereArrays& spheres)
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
  double half = 0.0;
  for (int axis = 0; axis < 3; ++axis)
  {
    const double low = -all.Values[axis];
    const double high = all.Values[3 + axis];
    this->Center[axis] = spheres.Count == 0 ? 0.0 : low + 0.5 * (high - low);
    half = spheres.Count == 0 ? 0.0 : std::max(half, 0.5 * (high - low));
  }
  this->Scale = half > 0.0 ? 1.0 / half : 1.0;
}

//------------------------------------------------------------------------------
BuildRange BuildSpheres::All() const
{
  BuildRange range;
  range.Count = static_cast<std::int64_t>(this->Spheres.size());
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
  std::int64_t left = range.First;
  std::int64_t right = range.First + range.Count - 1;
  const auto goesLeft = [&](std::int64_t i)
  { return binning.BinOf(this->Spheres[i], split.Axis) < split.Bin; };
  for (;;)
  {
    for (; left <= right && goesLeft(left); ++left)
    {
      centers[0].AddCenter(this->Spheres[left]);
    }
    for (; left <= right && !goesLeft(right); --right)
    {
      centers[1].AddCenter(this->Spheres[right]);
    }
    if (left > right)
    {
      return left;
    }
    std::swap(this->Spheres[left], this->Spheres[right]);
    std::swap(this->Ids[left], this->Ids[right]);
  }
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
