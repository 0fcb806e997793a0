// SPDX-License-Identifier: BSD-3-Clause
#include "metaballs/multilevel/GridHierarchy.h"

#include "base/Dispatch.h"
#include "metaballs/field/Blobs.h"
#include "metaballs/multilevel/Cells.h"
#include "metaballs/multilevel/GridTransfer.h"
#include "metaballs/multilevel/Anterpolate.h"

#if defined(SPHEREPACKING_HAS_AVX2)
#include "metaballs/SumFieldAvx2.h"
#endif

#include <algorithm>
#include <cmath>
#include <limits>

namespace spherepacking
{
namespace
{
// Gaussians are cut off at sqrt(2 CutOff) standard deviations.
constexpr double CutOff = 11.0;
// A term is one of those that become one where it falls by no more than this at the largest
// distance, see GaussianSum::Rest.
constexpr double Flat = 0.2;
// Meshes become coarser until they are so small or no longer smaller than this part of the one
// before; those of a long and thin grid are about half of it.
constexpr std::int64_t SmallMesh = 4096;
constexpr double Smaller = 0.7;

void Spread(FieldMesh& mesh, int y, int z)
{
#if defined(SPHEREPACKING_HAS_AVX2)
  if (HasAvx2())
  {
    SpreadCellsAvx2(mesh, y, z);
    return;
  }
#endif
  SpreadCells(mesh, y, z);
}

void Collect(const MeshRows& fine, MeshLevel& level, const NodeBox& box)
{
#if defined(SPHEREPACKING_HAS_AVX2)
  if (HasAvx2())
  {
    CollectChargesAvx2(fine, level, box);
    return;
  }
#endif
  CollectCharges(fine, level, box);
}

void MakeField(FieldMesh& mesh, std::size_t level, const NodeBox& box)
{
#if defined(SPHEREPACKING_HAS_AVX2)
  if (HasAvx2())
  {
    MakeMeshFieldAvx2(mesh, level, box);
    return;
  }
#endif
  MakeMeshField(mesh, level, box);
}

// Layers.
std::vector<NodeBox> CutBox(const NodeBox& box)
{
  constexpr int thickness = 2;
  std::vector<NodeBox> parts;
  for (int z = 0; z < box.Count[2]; z += thickness)
  {
    parts.push_back(box);
    parts.back().First[2] += z;
    parts.back().Count[2] = std::min(thickness, box.Count[2] - z);
  }
  return parts;
}

double GaussianOf(double distance, double variance)
{
  return std::exp(-0.5 * distance * distance / variance) / std::sqrt(2.0 * M_PI * variance);
}

int RadiusOf(double variance, double step)
{
  return static_cast<int>(std::ceil(std::sqrt(2.0 * CutOff * variance) / step));
}

MeshTaps TapsOf(int radius, double variance, double step, double factor)
{
  MeshTaps taps;
  taps.Radius = radius;
  for (int i = -radius; i <= radius; ++i)
  {
    taps.Weights.push_back(static_cast<float>(factor * GaussianOf(i * step, variance)));
  }
  return taps;
}

// Nodes that a charge is spread to; whole vectors along x.
void SetWindow(const double (&step)[3], int (&window)[3])
{
  const double largest = *std::max_element(step, step + 3);
  for (int axis = 0; axis < 3; ++axis)
  {
    window[axis] = static_cast<int>(std::ceil(2.0 * SpreadSteps * largest / step[axis] - 1e-9));
  }
  window[0] = (window[0] + 7) / 8 * 8;
}

class Builder
{
public:
  Builder(FieldMesh& mesh, const FieldGrid& grid, const ParallelFor& parallelFor)
    : Mesh(mesh)
    , Grid(grid)
    , Each(parallelFor)
    , Sum(mesh.Power, *std::max_element(grid.Spacing, grid.Spacing + 3))
  {
    std::copy_n(grid.Origin, 3, mesh.Origin);
    std::copy_n(grid.Spacing, 3, mesh.Step);
    mesh.Spread = this->Sum.SpreadOf(0);
    mesh.Reach = this->Sum.Reach;
    SetWindow(mesh.Step, mesh.Window);
    this->FitSmooth();
  }

  void Run(std::vector<Charge>&& charges)
  {
    this->MakeFinest(std::move(charges));
    while (this->AddLevel())
    {
    }
    for (std::size_t level = 0; level < this->Mesh.Levels.size(); ++level)
    {
      this->MakeKernels(level);
    }
    for (std::size_t level = this->Mesh.Levels.size(); --level > 0;)
    {
      MeshArray& field = this->Mesh.Levels[level].Field;
      field.Allocate();
      this->ForParts(
        field.Rows.Box, [&](const NodeBox& part) { MakeField(this->Mesh, level, part); });
      this->Mesh.Levels[level].Charges = MeshArray();
      if (level + 1 < this->Mesh.Levels.size())
      {
        this->Mesh.Levels[level + 1].Field = MeshArray(); // it is part of this one
      }
    }
  }

private:
  template <typename Work>
  void ForParts(const NodeBox& box, Work work) const
  {
    const std::vector<NodeBox> parts = CutBox(box);
    this->Each(static_cast<std::int64_t>(parts.size()), [&](std::int64_t i) { work(parts[i]); });
  }

  // Newton's interpolation in the square of the distance, at Chebyshev's places.
  void FitSmooth()
  {
    constexpr int terms = FieldMesh::Terms;
    double at[terms];
    double differences[terms];
    for (int i = 0; i < terms; ++i)
    {
      at[i] = 0.5 + 0.5 * std::cos(M_PI * (i + 0.5) / terms);
      differences[i] = this->Sum.Smooth(std::sqrt(at[i]) * this->Sum.Reach);
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
    std::copy_n(polynomial, terms, this->Mesh.Smooth);
  }

  void MakeFinest(std::vector<Charge>&& charges)
  {
    FieldMesh& mesh = this->Mesh;
    const ChargeBox box = BoxOf(charges);
    MeshLevel finest;
    NodeBox& nodes = finest.Charges.Rows.Box;
    for (int axis = 0; axis < 3; ++axis)
    {
      nodes.First[axis] = mesh.LowestNode(axis, box.Low[axis]);
      nodes.Count[axis] =
        mesh.LowestNode(axis, box.High[axis]) - nodes.First[axis] + mesh.Window[axis];
      finest.Field.Rows.Box.Count[axis] = static_cast<int>(this->Grid.Dimensions[axis]);
    }
    finest.Charges.Rows = MeshRows(nodes, 0);
    mesh.Levels.push_back(std::move(finest));
    SortIntoCells(std::move(charges), mesh, this->Each);
    this->SpreadAll();
  }

  void SpreadAll()
  {
    const FieldMesh& mesh = this->Mesh;
    MeshArray& charges = this->Mesh.Levels[0].Charges;
    charges.Allocate();
    const MeshRows& rows = charges.Rows;
    this->Each(rows.Box.Count[2],
      [&](std::int64_t z) { std::fill_n(rows.Values + z * rows.Step(2), rows.Step(2), 0.0f); });
    // Every other row of cells along y and z: those do not meet.
    for (int odd = 0; odd < 4; ++odd)
    {
      const int number = (mesh.Cells.Count[1] + 1 - odd % 2) / 2;
      const int layers = (mesh.Cells.Count[2] + 1 - odd / 2) / 2;
      this->Each(static_cast<std::int64_t>(number) * layers,
        [&](std::int64_t i)
        {
          Spread(this->Mesh, static_cast<int>(2 * (i % number)) + odd % 2,
            static_cast<int>(2 * (i / number)) + odd / 2);
        });
    }
  }

  double StepOf(std::size_t level, int axis) const
  {
    return std::ldexp(this->Mesh.Step[axis], static_cast<int>(level));
  }

  // Adds a mesh of twice the step, unless it would not be worth it.
  bool AddLevel()
  {
    const std::size_t level = this->Mesh.Levels.size();
    const int number = static_cast<int>(level);
    const MeshLevel& fine = this->Mesh.Levels.back();
    const double down = this->Sum.SpreadOf(number) - this->Sum.SpreadOf(number - 1);
    const double up =
      this->Sum.SpreadOf(number) - (level == 1 ? 0.0 : this->Sum.SpreadOf(number - 1));
    MeshLevel coarse;
    for (int axis = 0; axis < 3; ++axis)
    {
      const double step = this->StepOf(level, axis);
      const int radius = RadiusOf(down, 0.5 * step);
      coarse.Down.Along[axis] = TapsOf(radius, down, 0.5 * step, step);
      NodeBox& charges = coarse.Charges.Rows.Box;
      const int first = fine.Charges.Rows.Box.First[axis];
      charges.First[axis] = (first - radius + 1) >> 1;
      charges.Count[axis] =
        ((first + fine.Charges.Rows.Box.Count[axis] - 1 + radius) >> 1) - charges.First[axis] + 1;
      const int reach = (RadiusOf(up, 0.5 * step) + 2) / 2;
      for (int odd = 0; odd < 2; ++odd)
      {
        MeshTaps& taps = coarse.Up[odd].Along[axis];
        taps.Radius = reach;
        for (int i = -reach; i <= reach; ++i)
        {
          taps.Weights.push_back(static_cast<float>(step * GaussianOf((i - 0.5 * odd) * step, up)));
        }
      }
      NodeBox& field = coarse.Field.Rows.Box;
      const int start = fine.Field.Rows.Box.First[axis];
      field.First[axis] = (start >> 1) - reach;
      field.Count[axis] =
        ((start + fine.Field.Rows.Box.Count[axis] - 1) >> 1) + reach - field.First[axis] + 1;
    }
    const std::int64_t before = fine.Charges.Rows.Box.Nodes() + fine.Field.Rows.Box.Nodes();
    const std::int64_t after = coarse.Charges.Rows.Box.Nodes() + coarse.Field.Rows.Box.Nodes();
    if (level > 1 && (before < SmallMesh || after > Smaller * before))
    {
      return false;
    }
    coarse.Charges.Rows = MeshRows(coarse.Charges.Rows.Box, 0);
    coarse.Field.Rows = MeshRows(coarse.Field.Rows.Box, 0);
    coarse.Charges.Allocate();
    this->ForParts(coarse.Charges.Rows.Box,
      [&](const NodeBox& part) { Collect(fine.Charges.Rows, coarse, part); });
    this->Mesh.Levels.push_back(std::move(coarse));
    return true;
  }

  // One that takes charges of a mesh to its field.
  MeshLevel::Kernel KernelOf(std::size_t level, double rate, double weight) const
  {
    const int number = static_cast<int>(level);
    const double variance = 0.5 / (rate * rate);
    const double left =
      variance - (level == 0 ? this->Mesh.Spread : 2.0 * this->Sum.SpreadOf(number));
    const MeshLevel& own = this->Mesh.Levels[level];
    MeshLevel::Kernel kernel;
    for (int axis = 0; axis < 3; ++axis)
    {
      const double step = this->StepOf(level, axis);
      const NodeBox& from = own.Charges.Rows.Box;
      const NodeBox& to = own.Field.Rows.Box;
      const int farthest = std::max(from.First[axis] + from.Count[axis] - to.First[axis],
        to.First[axis] + to.Count[axis] - from.First[axis]);
      const int radius = std::min(RadiusOf(left, step), farthest);
      const double factor = std::sqrt(2.0 * M_PI * variance) * (axis == 0 ? weight : 1.0);
      kernel.Along[axis] = TapsOf(radius, left, step, factor);
    }
    return kernel;
  }

  void MakeKernels(std::size_t level)
  {
    std::vector<MeshLevel::Kernel>& kernels = this->Mesh.Levels[level].Kernels;
    const int first = level == 0 ? 0 : 2 * static_cast<int>(level) + 1;
    const bool last = level + 1 == this->Mesh.Levels.size();
    const int end = last ? std::numeric_limits<int>::max() : 2 * static_cast<int>(level) + 3;
    const double farthest = this->Farthest();
    for (int m = first; m < end; ++m)
    {
      double rate = this->Sum.Rate(m);
      double weight = this->Sum.Weight(m);
      const bool rest = last && rate * farthest < Flat;
      if (rest)
      {
        this->Sum.Rest(m, rate, weight);
      }
      kernels.push_back(this->KernelOf(level, rate, weight));
      if (rest)
      {
        return;
      }
    }
  }

  // No charge is farther from a place of the grid.
  double Farthest() const
  {
    const NodeBox& charges = this->Mesh.Levels[0].Charges.Rows.Box;
    double square = 0.0;
    for (int axis = 0; axis < 3; ++axis)
    {
      const int low = std::min(charges.First[axis], 0);
      const int high = std::max(
        charges.First[axis] + charges.Count[axis], static_cast<int>(this->Grid.Dimensions[axis]));
      square += std::pow((high - low) * this->Mesh.Step[axis], 2);
    }
    return std::sqrt(square);
  }

  FieldMesh& Mesh;
  const FieldGrid& Grid;
  const ParallelFor& Each;
  const GaussianSum Sum;
};
}

//------------------------------------------------------------------------------
bool IsForMesh(const std::vector<Charge>& charges, const FieldGrid& grid, int power)
{
  const double* spacing = grid.Spacing;
  const double largest = *std::max_element(spacing, spacing + 3);
  const double smallest = *std::min_element(spacing, spacing + 3);
  const std::int64_t fewest = *std::min_element(grid.Dimensions, grid.Dimensions + 3);
  // More charges in one place would lose too many digits, see AddInParts.
  constexpr std::size_t most = 4000000;
  if (charges.empty() || charges.size() > most || fewest < 12 || !(largest <= 2.0 * smallest))
  {
    return false;
  }
  float radius = 0.0f;
  for (const Charge& charge : charges)
  {
    radius = std::max(radius, charge.Radius);
  }
  // The sharp part of a kernel ends where it is constant.
  if (InverseBlob<1>::Core * radius > 0.5 * GaussianSum(power, largest).Reach)
  {
    return false;
  }
  const ChargeBox box = BoxOf(charges);
  int window[3];
  SetWindow(grid.Spacing, window);
  double nodes = 1.0;
  double places = 1.0;
  for (int axis = 0; axis < 3; ++axis)
  {
    // Meshes that have to reach far beyond the grid are no better than a tree.
    const double length = static_cast<double>(grid.Dimensions[axis]) * grid.Spacing[axis];
    if (box.High[axis] < grid.Origin[axis] - 2.0 * length ||
      box.Low[axis] > grid.Origin[axis] + 3.0 * length)
    {
      return false;
    }
    nodes *= (box.High[axis] - box.Low[axis]) / grid.Spacing[axis] + window[axis] + 1;
    places *= static_cast<double>(grid.Dimensions[axis]);
  }
  // Coarser meshes have a fifth of the finest's nodes for charges, and more than that of the grid's
  // places for their fields. With the charges, that makes 150 bytes a sphere.
  constexpr double valuesOfCharge = 22.0;
  return 1.2 * nodes + places / 4.5 <= valuesOfCharge * static_cast<double>(charges.size());
}

//------------------------------------------------------------------------------
std::unique_ptr<FieldMesh> BuildFieldMesh(
  std::vector<Charge>&& charges, const FieldGrid& grid, int power, const ParallelFor& parallelFor)
{
  auto mesh = std::make_unique<FieldMesh>();
  mesh->Power = power;
  Builder(*mesh, grid, parallelFor).Run(std::move(charges));
  return mesh;
}
}
