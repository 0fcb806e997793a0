// SPDX-License-Identifier: BSD-3-Clause
#include "metaballs/multilevel/GridHierarchy.h"

#include "base/Dispatch.h"
#include "metaballs/field/Blobs.h"
#include "metaballs/multilevel/Anterpolate.h"
#include "metaballs/multilevel/Cells.h"
#include "metaballs/multilevel/GaussianSum.h"
#include "metaballs/multilevel/GridTransfer.h"
#include "metaballs/multilevel/MultilevelAvx2.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace spherepacking
{
namespace
{
// Gaussians are truncated at sqrt(2 TruncationExponent) standard deviations, where they have fallen
// to exp(-TruncationExponent).
constexpr double TruncationExponent = 11.0;
// All terms of the sum whose rate times the largest distance is below this are merged into one, see
// GaussianSum::MergeTerms().
constexpr double MergedBelow = 0.2;
// Levels are added until one is this small, or the next would not be smaller by this factor; those
// of a long and thin grid shrink by about a half.
constexpr std::int64_t SmallLevel = 4096;
constexpr double MinShrinking = 0.7;

// Layers along z.
std::vector<GridBox> CutIntoLayers(const GridBox& box)
{
  constexpr int thickness = 2;
  std::vector<GridBox> layers;
  for (int z = 0; z < box.Count[2]; z += thickness)
  {
    layers.push_back(box);
    layers.back().First[2] += z;
    layers.back().Count[2] = std::min(thickness, box.Count[2] - z);
  }
  return layers;
}

double GaussianOf(double distance, double variance)
{
  return std::exp(-0.5 * distance * distance / variance) / std::sqrt(2.0 * M_PI * variance);
}

// Radius of the stencil of a Gaussian, in points.
int RadiusOf(double variance, double spacing)
{
  return static_cast<int>(std::ceil(std::sqrt(2.0 * TruncationExponent * variance) / spacing));
}

// Points that a charge is anterpolated to; whole vectors along x.
void SetWindow(const double (&spacing)[3], int (&window)[3])
{
  const double largest = *std::max_element(spacing, spacing + 3);
  for (int axis = 0; axis < 3; ++axis)
  {
    window[axis] =
      static_cast<int>(std::ceil(2.0 * AnterpolationRadius * largest / spacing[axis] - 1e-9));
  }
  window[0] = (window[0] + 7) / 8 * 8;
}

class HierarchyBuilder
{
public:
  HierarchyBuilder(
    GridHierarchy& hierarchy, const FieldGrid& grid, int power, const ParallelFor& parallelFor)
    : Hierarchy(hierarchy)
    , Grid(grid)
    , Each(parallelFor)
    , Sum(power, *std::max_element(grid.Spacing, grid.Spacing + 3))
  {
    std::copy_n(grid.Origin, 3, hierarchy.Origin);
    std::copy_n(grid.Spacing, 3, hierarchy.Spacing);
    hierarchy.ChargeVariance = this->Sum.ChargeVariance(0);
    hierarchy.Cutoff = this->Sum.Cutoff;
    SetWindow(hierarchy.Spacing, hierarchy.Window);
    this->FitLongRange();
  }

  void Run(std::vector<Charge>&& charges)
  {
    this->MakeFinest(std::move(charges));
    while (this->AddLevel())
    {
    }
    for (std::size_t level = 0; level < this->Hierarchy.Levels.size(); ++level)
    {
      this->MakeTerms(level);
    }
    // From coarse to fine, each with the fields of the levels before.
    for (std::size_t level = this->Hierarchy.Levels.size(); --level > 0;)
    {
      GridArray& field = this->Hierarchy.Levels[level].Field;
      field.Allocate();
      this->ForLayers(field.Rows.Box, [&](const GridBox& part)
        { SPHEREPACKING_DISPATCH(SetField)(this->Hierarchy, level, part); });
      this->Hierarchy.Levels[level].Charges = GridArray();
      if (level + 1 < this->Hierarchy.Levels.size())
      {
        this->Hierarchy.Levels[level + 1].Field = GridArray(); // it is part of this one
      }
    }
  }

private:
  template <typename Work>
  void ForLayers(const GridBox& box, Work work) const
  {
    const std::vector<GridBox> layers = CutIntoLayers(box);
    this->Each(static_cast<std::int64_t>(layers.size()), [&](std::int64_t i) { work(layers[i]); });
  }

  // Newton's interpolation of the long-range terms by a polynomial in the square of the distance
  // over Cutoff, at Chebyshev nodes; divided differences first, then the coefficients of the
  // powers.
  void FitLongRange()
  {
    constexpr int terms = GridHierarchy::LongRangeTerms;
    double at[terms];
    double differences[terms];
    for (int i = 0; i < terms; ++i)
    {
      at[i] = 0.5 + 0.5 * std::cos(M_PI * (i + 0.5) / terms);
      differences[i] = this->Sum.LongRange(std::sqrt(at[i]) * this->Sum.Cutoff);
    }
    for (int order = 1; order < terms; ++order)
    {
      for (int i = terms - 1; i >= order; --i)
      {
        differences[i] = (differences[i] - differences[i - 1]) / (at[i] - at[i - order]);
      }
    }
    double polynomial[terms] = {};
    for (int i = terms - 1; i >= 0; --i)
    {
      for (int n = terms - 1; n > 0; --n)
      {
        polynomial[n] = polynomial[n - 1] - at[i] * polynomial[n];
      }
      polynomial[0] = differences[i] - at[i] * polynomial[0];
    }
    std::copy_n(polynomial, terms, this->Hierarchy.LongRange);
  }

  void MakeFinest(std::vector<Charge>&& charges)
  {
    GridHierarchy& hierarchy = this->Hierarchy;
    const Box bounds = BoundsOf(charges);
    GridLevel finest;
    GridBox& box = finest.Charges.Rows.Box;
    for (int axis = 0; axis < 3; ++axis)
    {
      box.First[axis] = hierarchy.FirstPoint(axis, bounds.Low[axis]);
      box.Count[axis] =
        hierarchy.FirstPoint(axis, bounds.High[axis]) - box.First[axis] + hierarchy.Window[axis];
      finest.Field.Rows.Box.Count[axis] = static_cast<int>(this->Grid.Dimensions[axis]);
    }
    finest.Charges.Rows = GridRows(box, 0);
    hierarchy.Levels.push_back(std::move(finest));
    SortIntoCells(std::move(charges), hierarchy, this->Each);
    this->AnterpolateAll();
  }

  void AnterpolateAll()
  {
    const GridBox& cells = this->Hierarchy.Cells;
    GridArray& charges = this->Hierarchy.Levels[0].Charges;
    charges.Allocate();
    const GridRows& rows = charges.Rows;
    const std::ptrdiff_t layer = rows.StrideAlong(2);
    this->Each(rows.Box.Count[2],
      [&](std::int64_t z) { std::fill_n(rows.Values + z * layer, layer, 0.0f); });
    // Every other row of cells along y and z: those add to different points.
    for (int odd = 0; odd < 4; ++odd)
    {
      const int rowsAlongY = (cells.Count[1] + 1 - odd % 2) / 2;
      const int rowsAlongZ = (cells.Count[2] + 1 - odd / 2) / 2;
      this->Each(static_cast<std::int64_t>(rowsAlongY) * rowsAlongZ,
        [&](std::int64_t i)
        {
          const int y = static_cast<int>(2 * (i % rowsAlongY)) + odd % 2;
          const int z = static_cast<int>(2 * (i / rowsAlongY)) + odd / 2;
          SPHEREPACKING_DISPATCH(AnterpolateCells)(this->Hierarchy, y, z);
        });
    }
  }

  double SpacingOf(std::size_t level, int axis) const
  {
    return std::ldexp(this->Hierarchy.Spacing[axis], static_cast<int>(level));
  }

  // The weights of a Gaussian at the points around one that lies `shift` points from point 0.
  static AxisStencil GaussianStencil(
    int radius, double shift, double variance, double spacing, double factor)
  {
    AxisStencil stencil;
    stencil.Radius = radius;
    for (int i = -radius; i <= radius; ++i)
    {
      stencil.Weights.push_back(
        static_cast<float>(factor * GaussianOf((i - shift) * spacing, variance)));
    }
    return stencil;
  }

  // A level of twice the spacing without its values: the stencils from and to `fine`, a box for all
  // charges of `fine`, and one for all points from which its field is interpolated.
  GridLevel Coarsen(const GridLevel& fine) const
  {
    const std::size_t level = this->Hierarchy.Levels.size();
    const int number = static_cast<int>(level);
    const double own = this->Sum.ChargeVariance(number);
    const double finer = this->Sum.ChargeVariance(number - 1);
    const double down = own - finer;
    const double up = own - (level == 1 ? 0.0 : finer);
    GridLevel coarse;
    for (int axis = 0; axis < 3; ++axis)
    {
      const double spacing = this->SpacingOf(level, axis);
      const int radius = RadiusOf(down, 0.5 * spacing);
      coarse.Restriction.Along[axis] = GaussianStencil(radius, 0.0, down, 0.5 * spacing, spacing);
      GridBox& charges = coarse.Charges.Rows.Box;
      const int first = fine.Charges.Rows.Box.First[axis];
      charges.First[axis] = (first - radius + 1) >> 1;
      charges.Count[axis] =
        ((first + fine.Charges.Rows.Box.Count[axis] - 1 + radius) >> 1) - charges.First[axis] + 1;
      const int reach = (RadiusOf(up, 0.5 * spacing) + 2) / 2;
      for (int odd = 0; odd < 2; ++odd)
      {
        coarse.Prolongation[odd].Along[axis] =
          GaussianStencil(reach, 0.5 * odd, up, spacing, spacing);
      }
      GridBox& field = coarse.Field.Rows.Box;
      const int start = fine.Field.Rows.Box.First[axis];
      field.First[axis] = (start >> 1) - reach;
      field.Count[axis] =
        ((start + fine.Field.Rows.Box.Count[axis] - 1) >> 1) + reach - field.First[axis] + 1;
    }
    return coarse;
  }

  // Adds a coarser level with its charges, unless the work that it would save is small.
  bool AddLevel()
  {
    const GridLevel& fine = this->Hierarchy.Levels.back();
    GridLevel coarse = this->Coarsen(fine);
    const std::int64_t before = fine.Charges.Rows.Box.Size() + fine.Field.Rows.Box.Size();
    const std::int64_t after = coarse.Charges.Rows.Box.Size() + coarse.Field.Rows.Box.Size();
    if (this->Hierarchy.Levels.size() > 1 && (before < SmallLevel || after > MinShrinking * before))
    {
      return false;
    }
    coarse.Charges.Rows = GridRows(coarse.Charges.Rows.Box, 0);
    coarse.Field.Rows = GridRows(coarse.Field.Rows.Box, 0);
    coarse.Charges.Allocate();
    this->ForLayers(coarse.Charges.Rows.Box, [&](const GridBox& part)
      { SPHEREPACKING_DISPATCH(Restrict)(fine.Charges.Rows, coarse, part); });
    this->Hierarchy.Levels.push_back(std::move(coarse));
    return true;
  }

  // The stencil of a term, which takes the charges of a level to its field.
  Stencil StencilOf(std::size_t level, double rate, double weight) const
  {
    const int number = static_cast<int>(level);
    const double variance = 0.5 / (rate * rate);
    // Charges and field have the rest of the variance already.
    const double missing = variance -
      (level == 0 ? this->Hierarchy.ChargeVariance : 2.0 * this->Sum.ChargeVariance(number));
    const GridLevel& own = this->Hierarchy.Levels[level];
    Stencil stencil;
    for (int axis = 0; axis < 3; ++axis)
    {
      const double spacing = this->SpacingOf(level, axis);
      const GridBox& from = own.Charges.Rows.Box;
      const GridBox& to = own.Field.Rows.Box;
      const int farthest = std::max(from.First[axis] + from.Count[axis] - to.First[axis],
        to.First[axis] + to.Count[axis] - from.First[axis]);
      const int radius = std::min(RadiusOf(missing, spacing), farthest);
      const double factor = std::sqrt(2.0 * M_PI * variance) * (axis == 0 ? weight : 1.0);
      stencil.Along[axis] = GaussianStencil(radius, 0.0, missing, spacing, factor);
    }
    return stencil;
  }

  void MakeTerms(std::size_t level)
  {
    std::vector<Stencil>& terms = this->Hierarchy.Levels[level].Terms;
    const int first = level == 0 ? 0 : 2 * static_cast<int>(level) + 1;
    const bool coarsest = level + 1 == this->Hierarchy.Levels.size();
    const int end = coarsest ? std::numeric_limits<int>::max() : 2 * static_cast<int>(level) + 3;
    const double farthest = this->Farthest();
    for (int m = first; m < end; ++m)
    {
      double rate = this->Sum.Rate(m);
      double weight = this->Sum.Weight(m);
      const bool merged = coarsest && rate * farthest < MergedBelow;
      if (merged)
      {
        this->Sum.MergeTerms(m, rate, weight);
      }
      terms.push_back(this->StencilOf(level, rate, weight));
      if (merged)
      {
        return;
      }
    }
  }

  // Bound for the distances of charges from points of the field.
  double Farthest() const
  {
    const GridBox& charges = this->Hierarchy.Levels[0].Charges.Rows.Box;
    double square = 0.0;
    for (int axis = 0; axis < 3; ++axis)
    {
      const int low = std::min(charges.First[axis], 0);
      const int high = std::max(
        charges.First[axis] + charges.Count[axis], static_cast<int>(this->Grid.Dimensions[axis]));
      square += std::pow((high - low) * this->Hierarchy.Spacing[axis], 2);
    }
    return std::sqrt(square);
  }

  GridHierarchy& Hierarchy;
  const FieldGrid& Grid;
  const ParallelFor& Each;
  const GaussianSum Sum;
};
}

//------------------------------------------------------------------------------
bool SuitsMultilevel(const std::vector<Charge>& charges, const FieldGrid& grid, int power)
{
  const double* spacing = grid.Spacing;
  const double largest = *std::max_element(spacing, spacing + 3);
  const double smallest = *std::min_element(spacing, spacing + 3);
  const std::int64_t fewest = *std::min_element(grid.Dimensions, grid.Dimensions + 3);
  // Sums of more coincident charges would lose too many digits, see AddInBatches().
  constexpr std::size_t maxCharges = 4000000;
  if (charges.empty() || charges.size() > maxCharges || fewest < 12 || !(largest <= 2.0 * smallest))
  {
    return false;
  }
  float radius = 0.0f;
  for (const Charge& charge : charges)
  {
    radius = std::max(radius, charge.Radius);
  }
  // The constant core of a kernel has to be short-range.
  if (InverseBlob<1>::Core * radius > 0.5 * GaussianSum(power, largest).Cutoff)
  {
    return false;
  }
  const Box bounds = BoundsOf(charges);
  int window[3];
  SetWindow(grid.Spacing, window);
  double chargePoints = 1.0;
  double fieldPoints = 1.0;
  for (int axis = 0; axis < 3; ++axis)
  {
    // Grids that have to reach from the field to charges far away are no better than a tree.
    const double length = static_cast<double>(grid.Dimensions[axis]) * grid.Spacing[axis];
    if (bounds.High[axis] < grid.Origin[axis] - 2.0 * length ||
      bounds.Low[axis] > grid.Origin[axis] + 3.0 * length)
    {
      return false;
    }
    chargePoints *= (bounds.High[axis] - bounds.Low[axis]) / grid.Spacing[axis] + window[axis] + 1;
    fieldPoints *= static_cast<double>(grid.Dimensions[axis]);
  }
  // The coarser levels have a fifth of the finest's points for charges, and more than a fifth of
  // the field's points for their fields. With the charges, that makes 150 bytes per sphere.
  constexpr double valuesPerCharge = 22.0;
  return 1.2 * chargePoints + fieldPoints / 4.5 <=
    valuesPerCharge * static_cast<double>(charges.size());
}

//------------------------------------------------------------------------------
std::unique_ptr<GridHierarchy> BuildGridHierarchy(
  std::vector<Charge>&& charges, const FieldGrid& grid, int power, const ParallelFor& parallelFor)
{
  auto hierarchy = std::make_unique<GridHierarchy>();
  HierarchyBuilder(*hierarchy, grid, power, parallelFor).Run(std::move(charges));
  return hierarchy;
}
}
