// SPDX-License-Identifier: BSD-3-Clause
/// Charges and their field on meshes, see GaussianSum.h.
#ifndef GridHierarchy_h
#define GridHierarchy_h

#include "base/HugeArray.h"
#include "metaballs/multipole/ChargeTree.h"
#include "metaballs/field/FieldGrid.h"
#include "metaballs/multilevel/GaussianSum.h"

#include <cmath>
#include <memory>
#include <vector>

namespace spherepacking
{
/// Nodes of a mesh, by their numbers: node 0 of all meshes is at the grid's origin.
struct NodeBox
{
  int First[3] = {};
  int Count[3] = {};

  SPHEREPACKING_INLINE std::int64_t Nodes() const
  {
    return static_cast<std::int64_t>(this->Count[0]) * this->Count[1] * this->Count[2];
  }
};

/// Values at the nodes of a box, x fastest. Rows are whole eights, but no multiples
/// of 32 values, so that neighbours do not compete for places in the cache.
struct MeshRows
{
  NodeBox Box;
  std::ptrdiff_t Stride = 0; ///< of rows
  float* Values = nullptr;

  MeshRows() = default;
  /// With room for so many more values in each row.
  SPHEREPACKING_INLINE explicit MeshRows(const NodeBox& box, int room)
    : Box(box)
    , Stride((box.Count[0] + room + 7) / 8 * 8)
  {
    this->Stride += this->Stride % 32 == 0 ? 8 : 0;
  }

  SPHEREPACKING_INLINE std::ptrdiff_t Size() const
  {
    return this->Stride * this->Box.Count[1] * this->Box.Count[2];
  }
  SPHEREPACKING_INLINE int Width() const { return (this->Box.Count[0] + 7) / 8 * 8; }
  SPHEREPACKING_INLINE std::ptrdiff_t Step(int axis) const
  {
    return axis == 1 ? this->Stride : this->Stride * this->Box.Count[1];
  }
  SPHEREPACKING_INLINE float* At(int x, int y, int z) const
  {
    return this->Values + (x - this->Box.First[0]) +
      this->Stride *
      (y - this->Box.First[1] +
        static_cast<std::ptrdiff_t>(this->Box.Count[1]) * (z - this->Box.First[2]));
  }
};

struct MeshArray
{
  MeshRows Rows;

  void Allocate()
  {
    this->Values = HugeArray<float>(static_cast<std::size_t>(this->Rows.Size()));
    this->Rows.Values = this->Values.data();
  }

private:
  HugeArray<float> Values;
};

/// Weights of the nodes from -Radius to Radius.
struct MeshTaps
{
  int Radius = 0;
  std::vector<float> Weights;
};

struct MeshLevel
{
  MeshArray Charges;
  MeshArray Field; ///< empty for mesh 0, whose field is made block by block
  struct Kernel
  {
    MeshTaps Along[3];
  };
  std::vector<Kernel> Kernels; ///< of the terms that are made here
  Kernel Down;                 ///< to these charges from those of the mesh before
  Kernel Up[2]; ///< to the even and to the odd nodes of the mesh before, from this field
};

struct FieldMesh
{
  static constexpr int Terms = 8;

  int Power = 1;
  double Origin[3];
  double Step[3];
  double Spread = 0.0; ///< variance of a charge on mesh 0
  double Reach = 0.0;  ///< of the terms that are summed charge by charge
  float Smooth[Terms]; ///< the others, a polynomial of (d / Reach)^2
  int Window[3];       ///< nodes that a charge is spread to
  /// Each has charges whose lowest nodes are among Window nodes; First is the lowest of all.
  NodeBox Cells;
  std::vector<std::int32_t> CellStarts;
  std::vector<Charge> Charges; ///< cell by cell
  std::vector<MeshLevel> Levels;

  /// Of those that a charge is spread to. Grows with x.
  SPHEREPACKING_INLINE int LowestNode(int axis, double x) const
  {
    return static_cast<int>(
      std::ceil((x - this->Origin[axis]) / this->Step[axis] - 0.5 * this->Window[axis]));
  }

  /// The number of a cell's first charge; the next cell's is where they end.
  SPHEREPACKING_INLINE const std::int32_t* CellAt(int x, int y, int z) const
  {
    const NodeBox& cells = this->Cells;
    return this->CellStarts.data() + x +
      cells.Count[0] * (y + static_cast<std::ptrdiff_t>(cells.Count[1]) * z);
  }
};

/// Whether the field of the charges can be had through meshes, in less time than through a tree and
/// with little memory beside the charges.
bool IsForMesh(const std::vector<Charge>& charges, const FieldGrid& grid, int power);

std::unique_ptr<FieldMesh> BuildFieldMesh(
  std::vector<Charge>&& charges, const FieldGrid& grid, int power, const ParallelFor& parallelFor);
}

#endif
