// SPDX-License-Identifier: BSD-3-Clause
#include "vtkSpherePackingVertices.h"

#include "vtkArrayDispatch.h"
#include "vtkBoundingBox.h"
#include "vtkDataArray.h"
#include "vtkDataArrayRange.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"
#include "vtkSMPTools.h"
#include "vtkSpherePackingSplit.h"
#include "vtkUnsignedCharArray.h"

#include <algorithm>
#include <cstdint>
#include <utility>

VTK_ABI_NAMESPACE_BEGIN
namespace
{
constexpr vtkIdType BlockSize = 256;

// 21 bits of each coordinate, interleaved: points that are near in this order are near in space.
// (Morton, "A Computer Oriented Geodetic Data Base", 1966.)
struct MortonKeys
{
  std::vector<std::pair<std::uint64_t, vtkIdType>> Keys;

  static std::uint64_t Spread(std::uint64_t x)
  {
    x = (x | x << 32) & 0x001f00000000ffffull;
    x = (x | x << 16) & 0x001f0000ff0000ffull;
    x = (x | x << 8) & 0x100f00f00f00f00full;
    x = (x | x << 4) & 0x10c30c30c30c30c3ull;
    x = (x | x << 2) & 0x1249249249249249ull;
    return x;
  }

  template <typename PointsT>
  void operator()(PointsT* points, const double bounds[6])
  {
    const auto centres = vtk::DataArrayTupleRange<3>(points);
    this->Keys.resize(centres.size());
    const double length =
      std::max({ bounds[1] - bounds[0], bounds[3] - bounds[2], bounds[5] - bounds[4] });
    const double scale = length > 0.0 ? ((1 << 21) - 1) / length : 0.0;
    vtkSMPTools::For(0, centres.size(),
      [&](vtkIdType begin, vtkIdType end)
      {
        for (vtkIdType i = begin; i < end; ++i)
        {
          std::uint64_t key = 0;
          for (int axis = 0; axis < 3; ++axis)
          {
            const double x = static_cast<double>(centres[i][axis]) - bounds[2 * axis];
            key |= Spread(static_cast<std::uint64_t>(x * scale)) << axis;
          }
          this->Keys[i] = { key, i };
        }
      });
  }
};

struct FillGeometry
{
  template <typename PointsT, typename RadiiT>
  void operator()(PointsT* points, RadiiT* radii, const std::array<double, 3>& origin,
    const std::vector<vtkIdType>& ids, std::vector<vtkSpherePackingVertex>& vertices)
  {
    const auto centres = vtk::DataArrayTupleRange<3>(points);
    const auto r = vtk::DataArrayValueRange<1>(radii);
    vtkSMPTools::For(0, static_cast<vtkIdType>(ids.size()),
      [&](vtkIdType begin, vtkIdType end)
      {
        for (vtkIdType i = begin; i < end; ++i)
        {
          vtkSpherePackingVertex& vertex = vertices[i];
          for (int axis = 0; axis < 3; ++axis)
          {
            const double x = static_cast<double>(centres[ids[i]][axis]) - origin[axis];
            vtkSpherePackingSplit(x, vertex.High[axis], vertex.Low[axis]);
          }
          vertex.Radius = static_cast<float>(r[ids[i]]);
        }
      });
  }
};
}

//------------------------------------------------------------------------------
void vtkSpherePackingFillColor(unsigned char rgba[4], vtkUnsignedCharArray* colors, vtkIdType id)
{
  std::fill_n(rgba, 4, static_cast<unsigned char>(255));
  if (colors)
  {
    const int components = colors->GetNumberOfComponents();
    const unsigned char* from = colors->GetPointer(components * id);
    for (int i = 0; i < 3; ++i)
    {
      rgba[i] = from[components < 3 ? 0 : i];
    }
    if (components % 2 == 0)
    {
      rgba[3] = from[components - 1];
    }
  }
}

//------------------------------------------------------------------------------
void vtkSpherePackingFillId(unsigned char bytes[4], vtkIdType id)
{
  for (int i = 0; i < 4; ++i)
  {
    bytes[i] = static_cast<unsigned char>((id >> (8 * i)) & 0xff);
  }
}

//------------------------------------------------------------------------------
std::vector<vtkSpherePackingVertex> vtkSpherePackingVertices::Build(
  vtkPolyData* packing, vtkDataArray* radii, vtkUnsignedCharArray* colors)
{
  const vtkIdType count = packing->GetNumberOfPoints();
  std::vector<vtkSpherePackingVertex> vertices(count);
  this->PointIds.resize(count);

  double bounds[6];
  packing->GetPoints()->GetBounds(bounds);
  for (int axis = 0; axis < 3; ++axis)
  {
    this->Origin[axis] = 0.5 * (bounds[2 * axis] + bounds[2 * axis + 1]);
  }

  vtkDataArray* points = packing->GetPoints()->GetData();
  this->SortIds(points, bounds);
  FillGeometry fill;
  using Dispatcher =
    vtkArrayDispatch::Dispatch2ByValueType<vtkArrayDispatch::Reals, vtkArrayDispatch::AllTypes>;
  if (!Dispatcher::Execute(points, radii, fill, this->Origin, this->PointIds, vertices))
  {
    fill(points, radii, this->Origin, this->PointIds, vertices);
  }

  vtkSMPTools::For(0, count,
    [&](vtkIdType begin, vtkIdType end)
    {
      for (vtkIdType i = begin; i < end; ++i)
      {
        vtkSpherePackingFillColor(vertices[i].Color, colors, this->PointIds[i]);
      }
    });
  this->BuildBlocks(vertices);
  return vertices;
}

//------------------------------------------------------------------------------
void vtkSpherePackingVertices::SortIds(vtkDataArray* points, const double bounds[6])
{
  MortonKeys keys;
  if (!vtkArrayDispatch::DispatchByValueType<vtkArrayDispatch::Reals>::Execute(
        points, keys, bounds))
  {
    keys(points, bounds);
  }
  vtkSMPTools::Sort(keys.Keys.begin(), keys.Keys.end());
  vtkSMPTools::For(0, static_cast<vtkIdType>(keys.Keys.size()),
    [&](vtkIdType begin, vtkIdType end)
    {
      for (vtkIdType i = begin; i < end; ++i)
      {
        this->PointIds[i] = keys.Keys[i].second;
      }
    });
}

//------------------------------------------------------------------------------
void vtkSpherePackingVertices::BuildBlocks(const std::vector<vtkSpherePackingVertex>& vertices)
{
  const vtkIdType count = static_cast<vtkIdType>(vertices.size());
  std::vector<float> radii;
  for (vtkIdType i = 0; i < count; i += 1 + count / 4096)
  {
    radii.push_back(vertices[i].Radius);
  }
  if (!radii.empty())
  {
    const auto usual = radii.begin() + 3 * radii.size() / 4;
    std::nth_element(radii.begin(), usual, radii.end());
    this->UsualRadius = *usual;
  }
  this->Blocks.resize((count + BlockSize - 1) / BlockSize);
  vtkSMPTools::For(0, static_cast<vtkIdType>(this->Blocks.size()),
    [&](vtkIdType begin, vtkIdType end)
    {
      for (vtkIdType b = begin; b < end; ++b)
      {
        vtkSpherePackingBlock& block = this->Blocks[b];
        block.Begin = b * BlockSize;
        block.End = std::min(block.Begin + BlockSize, count);
        block.MaximumRadius = 0.0;
        vtkBoundingBox box;
        for (vtkIdType i = block.Begin; i < block.End; ++i)
        {
          const vtkSpherePackingVertex& v = vertices[i];
          const double r = v.Radius;
          block.MaximumRadius = std::max(block.MaximumRadius, r);
          const double c[3] = { this->Origin[0] + v.High[0] + v.Low[0],
            this->Origin[1] + v.High[1] + v.Low[1], this->Origin[2] + v.High[2] + v.Low[2] };
          const double bounds[6] = { c[0] - r, c[0] + r, c[1] - r, c[1] + r, c[2] - r, c[2] + r };
          box.AddBounds(bounds);
        }
        box.GetBounds(block.Bounds.data());
      }
    });
}
VTK_ABI_NAMESPACE_END
