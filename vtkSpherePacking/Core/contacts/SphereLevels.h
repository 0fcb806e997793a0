// SPDX-License-Identifier: BSD-3-Clause
#ifndef SphereLevels_h
#define SphereLevels_h

#include "base/HugeArray.h"
#include "base/ParallelFor.h"
#include "base/Vector3.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <functional>
#include <vector>

namespace spherepacking
{
/// A sphere with its number in the packing.
struct NumberedSphere
{
  Vector3 Center;
  double Radius;
  std::int32_t Id;
};

/**
 * A grid of cells for every order of magnitude of the radii, to find neighbours among spheres of
 * very different sizes (H. Mio et al., "Cell optimization for fast contact detection in the
 * discrete element method algorithm", 2007; V. Ogarko and S. Luding, "A fast multilevel algorithm
 * for contact detection of arbitrarily polydisperse objects", 2012).
 *
 * A sphere lies in the cell of its centre, in the level whose cells are as wide as two of the
 * largest reaches there; a reach is a radius and the padding. Whatever the sizes, the neighbours in
 * a level are found in at most three cells along each axis, and no more spheres lie there than a
 * few times those that are neighbours of each other. Cells are numbered from the middle of most
 * spheres, and stored in a table of about twice as many places as spheres, so that neither empty
 * space nor a few spheres far away cost anything.
 */
class SphereLevels
{
public:
  using SphereAt = std::function<NumberedSphere(std::int64_t)>;

  /// `padding` is half of the gap that neighbours may have, or more.
  SphereLevels(
    std::int64_t count, const SphereAt& sphereAt, double padding, const ParallelFor& parallelFor);

  int LevelCount() const { return static_cast<int>(this->Levels.size()); }

  /// The places of the spheres of a level, those of the finest first; the end of one is the begin
  /// of the next.
  std::int64_t Begin(int level) const { return this->Levels[level].Begin; }
  std::int64_t End(int level) const { return this->Levels[level].End; }

  /// The largest radius of a level.
  double LargestRadius(int level) const { return this->Levels[level].Largest; }

  const NumberedSphere& operator[](std::int64_t at) const { return this->Spheres[at]; }

  /// Calls visit(sphere) for every sphere of a level, from place `first` on, whose surface is no
  /// farther than `reach` from the point, but for rounding, and for none twice. The reach is at
  /// most the largest radius of the level and twice the padding. The caller's exact test comes
  /// after.
  template <typename Visit>
  void ForEachNeighbor(
    int level, const Vector3& center, double reach, std::int64_t first, const Visit& visit) const;

private:
  struct Level
  {
    double Largest = 0.0; // radius
    double PerCell = 1.0; // cells per length
    std::int64_t Low[3] = { 0, 0, 0 };
    std::int64_t High[3] = { 0, 0, 0 };
    std::uint64_t Strides[3] = { 1, 0, 0 };
    std::uint64_t Mask = 0; // all bits set if every cell has a place of its own
    std::int64_t Begin = 0;
    std::int64_t End = 0;
    std::int64_t FirstPlace = 0; // in Starts
    std::uint64_t Places = 0;
  };

  void FindFrame(std::int64_t count, const SphereAt& sphereAt);
  int LevelOf(double radius) const;
  void MakeLevels(std::int64_t count, const SphereAt& sphereAt, const ParallelFor& parallelFor);
  void ChoosePlaces(Level& level) const;
  void Sort(std::int64_t count, const SphereAt& sphereAt, const ParallelFor& parallelFor);

  // The cell of a coordinate. It never decreases as the coordinate grows, rounding included, so
  // that what lies between two coordinates lies between their cells.
  std::int64_t CellOf(const Level& level, double x, int axis) const
  {
    constexpr double most = 1e18;
    const double cell = std::floor((x - this->Middle[axis]) * level.PerCell);
    return static_cast<std::int64_t>(std::clamp(cell, -most, most));
  }

  std::uint64_t PlaceOf(const Level& level, std::int64_t x, std::int64_t y, std::int64_t z) const
  {
    return (static_cast<std::uint64_t>(x - level.Low[0]) +
             static_cast<std::uint64_t>(y - level.Low[1]) * level.Strides[1] +
             static_cast<std::uint64_t>(z - level.Low[2]) * level.Strides[2]) &
      level.Mask;
  }

  std::int64_t StartOf(const Level& level, std::uint64_t place) const
  {
    return this->Starts[static_cast<std::size_t>(level.FirstPlace) + place];
  }

  double Padding;
  double Middle[3];
  double Least;             // smaller reaches count as this
  int LeastExponent;        // of it
  std::vector<int> Numbers; // of the levels by exponent, -1 for none
  std::vector<Level> Levels;
  HugeArray<std::uint32_t> Starts;
  HugeArray<NumberedSphere> Spheres;
};

//------------------------------------------------------------------------------
template <typename Visit>
void SphereLevels::ForEachNeighbor(
  int number, const Vector3& center, double reach, std::int64_t first, const Visit& visit) const
{
  const Level& level = this->Levels[number];
  const double widest = reach + level.Largest;
  std::int64_t low[3];
  std::int64_t high[3];
  for (int axis = 0; axis < 3; ++axis)
  {
    low[axis] = std::max(this->CellOf(level, center[axis] - widest, axis), level.Low[axis]);
    high[axis] = std::min(this->CellOf(level, center[axis] + widest, axis), level.High[axis]);
    if (low[axis] > high[axis])
    {
      return;
    }
  }
  const auto range = [&](std::uint64_t begin, std::uint64_t end)
  {
    const std::int64_t last = this->StartOf(level, end);
    for (std::int64_t at = std::max(first, this->StartOf(level, begin)); at < last; ++at)
    {
      const NumberedSphere& sphere = this->Spheres[at];
      const Vector3 d = sphere.Center - center;
      const double sum = sphere.Radius + reach;
      if (Dot(d, d) <= sum * sum)
      {
        visit(sphere);
      }
    }
  };
  const std::uint64_t width = static_cast<std::uint64_t>(high[0] - low[0]) + 1;
  for (std::int64_t z = low[2]; z <= high[2]; ++z)
  {
    for (std::int64_t y = low[1]; y <= high[1]; ++y)
    {
      // Cells along x lie side by side, but for the end of the table.
      const std::uint64_t begin = this->PlaceOf(level, low[0], y, z);
      const std::uint64_t end = begin + width;
      range(begin, std::min(end, level.Places));
      if (end > level.Places)
      {
        range(0, end - level.Places);
      }
    }
  }
}
}

#endif
