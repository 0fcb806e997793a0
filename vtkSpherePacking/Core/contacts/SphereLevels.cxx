// SPDX-License-Identifier: BSD-3-Clause
#include "contacts/SphereLevels.h"

#include <array>
#include <atomic>
#include <memory>
#include <set>

namespace spherepacking
{
namespace
{
constexpr std::int64_t Chunk = 1 << 12;

// Levels are powers of two. Reaches above so many of them share the coarsest.
constexpr int MostLevels = 64;

// Wider than two of the largest reaches, so that rounding does not make it four cells to search.
constexpr double CellMargin = 1.001;

// Calls work(i) for 0 to count - 1.
template <typename Work>
void ForEach(std::int64_t count, const ParallelFor& parallelFor, const Work& work)
{
  parallelFor((count + Chunk - 1) / Chunk,
    [&](std::int64_t chunk)
    {
      const std::int64_t end = std::min((chunk + 1) * Chunk, count);
      for (std::int64_t i = chunk * Chunk; i < end; ++i)
      {
        work(i);
      }
    });
}

int ExponentOf(double x)
{
  int exponent;
  std::frexp(x, &exponent);
  return exponent;
}

// Whether no two of the cells that one search visits have the same place. Far away from the middle
// rounding may make these five along an axis.
bool AreApart(const std::uint64_t (&strides)[3], std::uint64_t mask)
{
  std::set<std::uint64_t> places;
  for (std::uint64_t z = 0; z < 5; ++z)
  {
    for (std::uint64_t y = 0; y < 5; ++y)
    {
      for (std::uint64_t x = 0; x < 5; ++x)
      {
        if (!places.insert((x + y * strides[1] + z * strides[2]) & mask).second)
        {
          return false;
        }
      }
    }
  }
  return true;
}
}

//------------------------------------------------------------------------------
SphereLevels::SphereLevels(
  std::int64_t count, const SphereAt& sphereAt, double padding, const ParallelFor& parallelFor)
  : Padding(padding)
{
  if (count > 0)
  {
    this->FindFrame(count, sphereAt);
    this->MakeLevels(count, sphereAt, parallelFor);
    this->Sort(count, sphereAt, parallelFor);
  }
}

//------------------------------------------------------------------------------
// The middle and the width of most spheres, from some of them: a few may be anywhere.
void SphereLevels::FindFrame(std::int64_t count, const SphereAt& sphereAt)
{
  constexpr std::int64_t most = 4096;
  const std::int64_t step = std::max<std::int64_t>(1, count / most);
  std::array<std::vector<double>, 3> samples;
  for (std::int64_t i = 0; i < count; i += step)
  {
    const NumberedSphere sample = sphereAt(i);
    for (int axis = 0; axis < 3; ++axis)
    {
      samples[axis].push_back(sample.Center[axis]);
    }
  }
  double width = 0.0;
  for (int axis = 0; axis < 3; ++axis)
  {
    std::vector<double>& values = samples[axis];
    std::sort(values.begin(), values.end());
    const std::size_t tenth = values.size() / 10;
    this->Middle[axis] = values[values.size() / 2];
    width = std::max(width, values[values.size() - 1 - tenth] - values[tenth]);
  }
  // Spheres of no reach would have cells of no width. These are narrower than what tells
  // coordinates apart that differ by much.
  this->Least = std::max(std::ldexp(width, -40), 1e-150);
  this->LeastExponent = ExponentOf(this->Least);
}

//------------------------------------------------------------------------------
int SphereLevels::LevelOf(double radius) const
{
  const int exponent = ExponentOf(std::max(radius + this->Padding, this->Least));
  return std::clamp(exponent - this->LeastExponent, 0, MostLevels - 1);
}

//------------------------------------------------------------------------------
void SphereLevels::MakeLevels(
  std::int64_t count, const SphereAt& sphereAt, const ParallelFor& parallelFor)
{
  struct Extent
  {
    std::int64_t Number = 0;
    double Largest = 0.0;
    double Low[3] = { HUGE_VAL, HUGE_VAL, HUGE_VAL };
    double High[3] = { -HUGE_VAL, -HUGE_VAL, -HUGE_VAL };

    void Add(const Extent& other)
    {
      this->Number += other.Number;
      this->Largest = std::max(this->Largest, other.Largest);
      for (int axis = 0; axis < 3; ++axis)
      {
        this->Low[axis] = std::min(this->Low[axis], other.Low[axis]);
        this->High[axis] = std::max(this->High[axis], other.High[axis]);
      }
    }
  };
  using Extents = std::array<Extent, MostLevels>;
  constexpr std::int64_t part = 1 << 16;
  std::vector<Extents> parts((count + part - 1) / part);
  parallelFor(static_cast<std::int64_t>(parts.size()),
    [&](std::int64_t k)
    {
      for (std::int64_t i = k * part; i < std::min((k + 1) * part, count); ++i)
      {
        const NumberedSphere one = sphereAt(i);
        const Vector3& c = one.Center;
        parts[k][this->LevelOf(one.Radius)].Add(
          { 1, one.Radius, { c.X, c.Y, c.Z }, { c.X, c.Y, c.Z } });
      }
    });
  this->Numbers.assign(MostLevels, -1);
  std::int64_t places = 0;
  std::int64_t begin = 0;
  for (int i = 0; i < MostLevels; ++i)
  {
    Extent extent;
    for (const Extents& extents : parts)
    {
      extent.Add(extents[i]);
    }
    if (extent.Number == 0)
    {
      continue;
    }
    Level level;
    level.Largest = extent.Largest;
    level.PerCell =
      1.0 / (2.0 * CellMargin * std::max(extent.Largest + this->Padding, this->Least));
    for (int axis = 0; axis < 3; ++axis)
    {
      level.Low[axis] = this->CellOf(level, extent.Low[axis], axis);
      level.High[axis] = this->CellOf(level, extent.High[axis], axis);
    }
    level.Begin = begin;
    level.End = begin + extent.Number;
    level.FirstPlace = places;
    this->ChoosePlaces(level);
    begin = level.End;
    places += static_cast<std::int64_t>(level.Places) + 1;
    this->Numbers[i] = this->LevelCount();
    this->Levels.push_back(level);
  }
  this->Starts = HugeArray<std::uint32_t>(places);
  this->Spheres = HugeArray<NumberedSphere>(count);
}

//------------------------------------------------------------------------------
// A place for every cell where they are not many more than the spheres, in rows along x. Otherwise
// rows begin anywhere in the table and share its places: spheres of other cells are no neighbours.
void SphereLevels::ChoosePlaces(Level& level) const
{
  const double most = 4.0 * static_cast<double>(level.End - level.Begin) + 1024.0;
  double cells[3];
  for (int axis = 0; axis < 3; ++axis)
  {
    cells[axis] = static_cast<double>(level.High[axis] - level.Low[axis]) + 1.0;
  }
  if (cells[0] * cells[1] * cells[2] <= most)
  {
    level.Strides[1] = static_cast<std::uint64_t>(cells[0]);
    level.Strides[2] = static_cast<std::uint64_t>(cells[0] * cells[1]);
    level.Mask = ~std::uint64_t{ 0 };
    level.Places = static_cast<std::uint64_t>(cells[0] * cells[1] * cells[2]);
    return;
  }
  level.Places = 1024;
  while (static_cast<double>(level.Places) < 0.5 * most)
  {
    level.Places *= 2;
  }
  level.Mask = level.Places - 1;
  // Odd numbers about the golden ratio's powers spread multiples evenly (D. Knuth, "The Art of
  // Computer Programming", volume 3, 1973, section 6.4).
  const double size = static_cast<double>(level.Places);
  for (std::uint64_t odd = 1;; odd += 2)
  {
    level.Strides[1] = static_cast<std::uint64_t>(0.6180339887 * size) | odd;
    level.Strides[2] = static_cast<std::uint64_t>(0.2360679775 * size) + 2 * odd + 1;
    if (AreApart(level.Strides, level.Mask))
    {
      return;
    }
  }
}

//------------------------------------------------------------------------------
void SphereLevels::Sort(
  std::int64_t count, const SphereAt& sphereAt, const ParallelFor& parallelFor)
{
  const std::int64_t places = static_cast<std::int64_t>(this->Starts.size());
  std::unique_ptr<std::atomic<std::uint32_t>[]> counts(new std::atomic<std::uint32_t>[places]());
  HugeArray<std::int64_t> placeOf(count);
  ForEach(count, parallelFor,
    [&](std::int64_t i)
    {
      const NumberedSphere one = sphereAt(i);
      const Level& level = this->Levels[this->Numbers[this->LevelOf(one.Radius)]];
      const std::int64_t place = level.FirstPlace +
        static_cast<std::int64_t>(this->PlaceOf(level, this->CellOf(level, one.Center.X, 0),
          this->CellOf(level, one.Center.Y, 1), this->CellOf(level, one.Center.Z, 2)));
      placeOf[i] = place;
      counts[place].fetch_add(1, std::memory_order_relaxed);
    });
  // The place after the last of a level holds none, so its start is the level's end.
  std::uint32_t sum = 0;
  for (std::int64_t place = 0; place < places; ++place)
  {
    this->Starts[place] = sum;
    sum += counts[place].load(std::memory_order_relaxed);
  }
  ForEach(count, parallelFor,
    [&](std::int64_t i)
    {
      const std::int64_t place = placeOf[i];
      const std::uint32_t before = counts[place].fetch_sub(1, std::memory_order_relaxed);
      this->Spheres[this->Starts[place] + before - 1] = sphereAt(i);
    });
}
}
