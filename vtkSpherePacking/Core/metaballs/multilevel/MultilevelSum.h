// SPDX-License-Identifier: BSD-3-Clause
#ifndef MultilevelSum_h
#define MultilevelSum_h

#include "metaballs/field/Blobs.h"
#include "metaballs/FieldScene.h"
#include "metaballs/multilevel/GridTransfer.h"

#include <cmath>

namespace spherepacking
{
inline namespace SPHEREPACKING_ISA
{
/// Sums the field of an inverse kernel over a part of a grid, through meshes: what is smooth from
/// these, what is sharp charge by charge.
template <int Power>
class MeshSummer
{
public:
  explicit MeshSummer(const FieldScene& scene)
    : Grid(scene.Grid)
    , Mesh(*scene.Mesh)
  {
  }

  void Run(const FieldBlock& block)
  {
    NodeBox box;
    for (int axis = 0; axis < 3; ++axis)
    {
      box.First[axis] = static_cast<int>(block.First[axis]);
      box.Count[axis] = block.Count[axis];
    }
    SumMeshes(this->Mesh, 0, box, this->Scratch);
    this->AddSharp();
    ForEachRow(box,
      [&](int y, int z)
      {
        std::copy_n(this->Scratch.Sums.Rows.At(box.First[0], y, z), box.Count[0],
          this->Grid.Field + this->Grid.Place(box.First[0], y, z));
      });
  }

private:
  // Goes through the cells that have charges within reach of the box.
  void AddSharp()
  {
    const NodeBox& cells = this->Mesh.Cells;
    int first[3];
    int last[3];
    for (int axis = 0; axis < 3; ++axis)
    {
      const NodeBox& box = this->Scratch.Sums.Rows.Box;
      const int reach = static_cast<int>(this->Mesh.Reach / this->Mesh.Step[axis]) + 1;
      const int size = this->Mesh.Window[axis];
      // Of the lowest nodes that charges are spread to, half a window below these.
      const int below = cells.First[axis] + size / 2;
      const int low = box.First[axis] - reach - 1 - below;
      const int high = box.First[axis] + box.Count[axis] + reach - below;
      first[axis] = std::max(low, 0) / size;
      last[axis] = std::min(high / size, cells.Count[axis] - 1);
      if (high < 0 || first[axis] > last[axis])
      {
        return;
      }
    }
    for (int y = first[1]; y <= last[1]; ++y)
    {
      for (int x = first[0]; x <= last[0]; ++x)
      {
        // Along z last: from one cell to the next most places are the same.
        for (int z = first[2]; z <= last[2]; ++z)
        {
          const std::int32_t* starts = this->Mesh.CellAt(x, y, z);
          AddInParts(this->Mesh.Charges.data() + starts[0], starts[1] - starts[0],
            this->Scratch.Sums.Rows.Box, this->Scratch.Sums.Rows, this->Scratch.Parts[0],
            [this](const Charge& charge, const MeshRows& to) { this->AddCharge(charge, to); });
        }
      }
    }
  }

  // Where a charge is in the box along an axis.
  struct Place
  {
    int First; // of the nodes within reach
    int Last;
    float Nearest; // node
    float Beyond;  // the nearest node, in space: exact in single precision also if tiny
    float Step;

    float Away(int node) const
    {
      return (static_cast<float>(node) - this->Nearest) * this->Step - this->Beyond;
    }
  };

  Place PlaceOf(int axis, double x) const
  {
    const NodeBox& box = this->Scratch.Sums.Rows.Box;
    const double step = this->Mesh.Step[axis];
    const double at = (x - this->Mesh.Origin[axis]) / step - box.First[axis];
    const double reach = this->Mesh.Reach / step;
    const double node = std::nearbyint(at);
    Place place;
    place.First = std::max(static_cast<int>(std::ceil(at - reach)), 0);
    place.Last = std::min(static_cast<int>(std::floor(at + reach)), box.Count[axis] - 1);
    place.Nearest = static_cast<float>(node);
    place.Beyond = static_cast<float>((at - node) * step);
    place.Step = static_cast<float>(step);
    return place;
  }

  void AddCharge(const Charge& charge, const MeshRows& rows) const
  {
    const Place x = this->PlaceOf(0, charge.X[0]);
    const Place y = this->PlaceOf(1, charge.X[1]);
    const Place z = this->PlaceOf(2, charge.X[2]);
    const SharpTerms sharp(this->Mesh, charge);
    for (int k = z.First; k <= z.Last; ++k)
    {
      const float dz = z.Away(k);
      float* row = rows.At(rows.Box.First[0], rows.Box.First[1] + y.First, rows.Box.First[2] + k);
      for (int j = y.First; j <= y.Last; ++j, row += rows.Stride)
      {
        const float dy = y.Away(j);
        const float aside = dy * dy + dz * dz;
        for (int i = x.First; aside < sharp.Most && i <= x.Last; i += 8)
        {
          const Float8 dx = (Lanes() + (static_cast<float>(i) - x.Nearest)) * x.Step - x.Beyond;
          Store(Load<Float8>(row + i) + sharp(dx * dx + aside), row + i);
        }
      }
    }
  }

  static Float8 Lanes() { return Float8{ 0.0f, 1.0f, 2.0f, 3.0f, 4.0f, 5.0f, 6.0f, 7.0f }; }

  // A charge's kernel less its smooth terms, 0 beyond the reach. Sums go through memory, which the
  // numbers here are not read from again.
  class SharpTerms
  {
  public:
    SharpTerms(const FieldMesh& mesh, const Charge& charge)
      : Most(static_cast<float>(mesh.Reach * mesh.Reach))
      , Inverse(1.0f / this->Most)
      , Strength(charge.Strength)
      , Shape(static_cast<float>(InverseBlob<Power>::Shape(charge.Radius)))
    {
      std::copy_n(mesh.Smooth, FieldMesh::Terms, this->Smooth);
    }

    Float8 operator()(const Float8& square) const
    {
      const Float8 share = square * this->Inverse;
      // Pairs of terms, then pairs of pairs: few that wait for each other.
      const float* s = this->Smooth;
      const Float8 second = share * share;
      const Float8 low = (s[0] + s[1] * share) + (s[2] + s[3] * share) * second;
      const Float8 high = (s[4] + s[5] * share) + (s[6] + s[7] * share) * second;
      static_assert(FieldMesh::Terms == 8, "as they are added");
      const Float8 smooth = low + high * (second * second);
      const Float8 all = InverseBlob<Power>::Value(square, Float8{} + 1.0f, Float8{} + this->Shape);
      const Float8 sharp = (all - smooth) * this->Strength;
      return square < this->Most ? sharp : Float8{};
    }

    const float Most;

  private:
    const float Inverse;
    const float Strength;
    const float Shape;
    float Smooth[FieldMesh::Terms];
  };

  const FieldGrid& Grid;
  const FieldMesh& Mesh;
  MeshScratch Scratch;
};
}
}

#endif
