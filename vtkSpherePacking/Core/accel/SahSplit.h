// SPDX-License-Identifier: BSD-3-Clause
/// Splits a range of boxes in two by the surface-area heuristic, over all axes.
///
/// Source: Wald, "On fast Construction of SAH-based Bounding Volume Hierarchies" (2007): the
/// centres are counted in bins, and the planes between bins are the candidates.
#ifndef SahSplit_h
#define SahSplit_h

#include <algorithm>
#include <cstdint>
#include <cstring>

namespace spherepacking
{
using Float4 = float __attribute__((vector_size(16)));
using Int4 = std::int32_t __attribute__((vector_size(16)));

/// A sphere as the builder sees it: single precision, the radius enlarged by what rounding needs.
struct alignas(16) BuildSphere
{
  float X[3];
  float R;

  Float4 Vector() const
  {
    Float4 vector;
    std::memcpy(&vector, this, sizeof(vector));
    return vector;
  }
};

inline Float4 Larger(const Float4& a, const Float4& b)
{
  return a > b ? a : b;
}

/// Lower ends are kept with the sign changed, so that all six grow by taking the larger. The fourth
/// element of each means nothing.
struct FloatBox
{
  static constexpr float Empty = -3e38f;

  Float4 Below = Float4{} + Empty;
  Float4 Above = Float4{} + Empty;

  void Add(const BuildSphere& sphere)
  {
    const Float4 center = sphere.Vector();
    this->Below = Larger(this->Below, sphere.R - center);
    this->Above = Larger(this->Above, sphere.R + center);
  }
  void AddCenter(const BuildSphere& sphere)
  {
    const Float4 center = sphere.Vector();
    this->Below = Larger(this->Below, -center);
    this->Above = Larger(this->Above, center);
  }
  void Add(const FloatBox& box)
  {
    this->Below = Larger(this->Below, box.Below);
    this->Above = Larger(this->Above, box.Above);
  }

  float Low(int axis) const { return -this->Below[axis]; }
  float High(int axis) const { return this->Above[axis]; }

  float HalfArea() const
  {
    const Float4 size = this->Below + this->Above;
    return size[0] * size[1] + size[1] * size[2] + size[2] * size[0];
  }
};

struct SahBins
{
  static constexpr int Maximum = 16;

  int Number; ///< in use along each axis
  FloatBox Boxes[3][Maximum];
  std::int64_t Counts[3][Maximum];

  /// Few spheres do not need many bins, whose handling would cost more than theirs.
  static int NumberFor(std::int64_t spheres) { return spheres < 64 ? 8 : Maximum; }

  explicit SahBins(int number)
    : Number(number)
    , Counts{}
  {
  }

  void Add(const SahBins& other)
  {
    for (int axis = 0; axis < 3; ++axis)
    {
      for (int bin = 0; bin < this->Number; ++bin)
      {
        this->Boxes[axis][bin].Add(other.Boxes[axis][bin]);
        this->Counts[axis][bin] += other.Counts[axis][bin];
      }
    }
  }
};

/// Maps centres to bins. An axis along which all centres are the same has one bin.
struct SahBinning
{
  static constexpr float Least = 1e-30f; ///< extent, so that its inverse is finite

  Float4 Low = {};
  Float4 Scale = {};

  SahBinning(const FloatBox& centers, int bins)
  {
    for (int axis = 0; axis < 3; ++axis)
    {
      const float extent = centers.High(axis) - centers.Low(axis);
      this->Low[axis] = centers.Low(axis);
      this->Scale[axis] = extent > Least ? static_cast<float>(bins) * 0.999999f / extent : 0.0f;
    }
  }

  bool CanSplit() const { return this->Scale[0] + this->Scale[1] + this->Scale[2] > 0.0f; }

  int BinOf(const BuildSphere& sphere, int axis) const
  {
    return static_cast<int>((sphere.X[axis] - this->Low[axis]) * this->Scale[axis]);
  }

  void Count(const BuildSphere* first, const BuildSphere* last, SahBins& bins) const
  {
    for (; first != last; ++first)
    {
      const Float4 scaled = (first->Vector() - this->Low) * this->Scale;
      const Int4 bin = __builtin_convertvector(scaled, Int4);
      for (int axis = 0; axis < 3; ++axis)
      {
        bins.Boxes[axis][bin[axis]].Add(*first);
        ++bins.Counts[axis][bin[axis]];
      }
    }
  }
};

/// Centres in bins before `Bin` along `Axis` go to the first side. Axis -1: there is no split.
struct SahSplit
{
  int Axis = -1;
  int Bin = 0;
  /// Sum over both sides of half the surface times the number of spheres.
  float Cost = 3e38f;
  FloatBox Boxes[2];
  std::int64_t Counts[2] = {};
};

inline SahSplit BestSplit(const SahBins& bins)
{
  SahSplit best;
  for (int axis = 0; axis < 3; ++axis)
  {
    FloatBox right[SahBins::Maximum];
    std::int64_t rightCount[SahBins::Maximum];
    FloatBox box;
    std::int64_t count = 0;
    for (int bin = bins.Number - 1; bin > 0; --bin)
    {
      box.Add(bins.Boxes[axis][bin]);
      count += bins.Counts[axis][bin];
      right[bin] = box;
      rightCount[bin] = count;
    }
    box = FloatBox();
    count = 0;
    for (int bin = 1; bin < bins.Number; ++bin)
    {
      box.Add(bins.Boxes[axis][bin - 1]);
      count += bins.Counts[axis][bin - 1];
      if (count == 0 || rightCount[bin] == 0)
      {
        continue;
      }
      const float cost = box.HalfArea() * static_cast<float>(count) +
        right[bin].HalfArea() * static_cast<float>(rightCount[bin]);
      if (cost < best.Cost)
      {
        best = { axis, bin, cost, { box, right[bin] }, { count, rightCount[bin] } };
      }
    }
  }
  return best;
}
}

#endif
