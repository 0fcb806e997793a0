// SPDX-License-Identifier: BSD-3-Clause
#include "impostor/PointSprites.h"

#include "impostor/SplitDouble.h"

#include "vtkArrayDispatch.h"
#include "vtkBoundingBox.h"
#include "vtkDataArray.h"
#include "vtkDataArrayRange.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"
#include "vtkSMPTools.h"
#include "vtkUnsignedCharArray.h"

#include <algorithm>
#include <cstdint>
#include <utility>

namespace spherepacking
{
namespace
{
constexpr vtkIdType ClusterSize = 256;

// Morton codes: 21 bits of each coordinate, interleaved. Points that are near each other in their
// order are near in space. (G. M. Morton, "A Computer Oriented Geodetic Data Base", 1966.)
struct MortonCodes
{
  std::vector<std::pair<std::uint64_t, vtkIdType>> Codes;

  // Puts two zero bits above each of the lower 21 bits.
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
    const auto centers = vtk::DataArrayTupleRange<3>(points);
    this->Codes.resize(centers.size());
    const double length =
      std::max({ bounds[1] - bounds[0], bounds[3] - bounds[2], bounds[5] - bounds[4] });
    const double scale = length > 0.0 ? ((1 << 21) - 1) / length : 0.0;
    vtkSMPTools::For(0, centers.size(),
      [&](vtkIdType begin, vtkIdType end)
      {
        for (vtkIdType i = begin; i < end; ++i)
        {
          std::uint64_t code = 0;
          for (int axis = 0; axis < 3; ++axis)
          {
            const double x = static_cast<double>(centers[i][axis]) - bounds[2 * axis];
            code |= Spread(static_cast<std::uint64_t>(x * scale)) << axis;
          }
          this->Codes[i] = { code, i };
        }
      });
  }
};

struct FillVertices
{
  template <typename PointsT, typename RadiiT>
  void operator()(PointsT* points, RadiiT* radii, const std::array<double, 3>& origin,
    const std::vector<vtkIdType>& ids, std::vector<SpriteVertex>& vertices)
  {
    const auto centers = vtk::DataArrayTupleRange<3>(points);
    const auto r = vtk::DataArrayValueRange<1>(radii);
    vtkSMPTools::For(0, static_cast<vtkIdType>(ids.size()),
      [&](vtkIdType begin, vtkIdType end)
      {
        for (vtkIdType i = begin; i < end; ++i)
        {
          SpriteVertex& vertex = vertices[i];
          for (int axis = 0; axis < 3; ++axis)
          {
            const double x = static_cast<double>(centers[ids[i]][axis]) - origin[axis];
            SplitDouble(x, vertex.CenterHigh[axis], vertex.CenterLow[axis]);
          }
          vertex.Radius = static_cast<float>(r[ids[i]]);
        }
      });
  }
};
}

//------------------------------------------------------------------------------
void PackColor(unsigned char rgba[4], vtkUnsignedCharArray* colors, vtkIdType id)
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
void PackId(unsigned char bytes[4], vtkIdType id)
{
  for (int i = 0; i < 4; ++i)
  {
    bytes[i] = static_cast<unsigned char>((id >> (8 * i)) & 0xff);
  }
}

//------------------------------------------------------------------------------
std::vector<SpriteVertex> PointSprites::Build(
  vtkPolyData* packing, vtkDataArray* radii, vtkUnsignedCharArray* colors)
{
  const vtkIdType count = packing->GetNumberOfPoints();
  std::vector<SpriteVertex> vertices(count);
  this->PointIds.resize(count);

  double bounds[6];
  packing->GetPoints()->GetBounds(bounds);
  for (int axis = 0; axis < 3; ++axis)
  {
    this->Origin[axis] = 0.5 * (bounds[2 * axis] + bounds[2 * axis + 1]);
  }

  vtkDataArray* points = packing->GetPoints()->GetData();
  this->SortIds(points, bounds);
  FillVertices fill;
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
        PackColor(vertices[i].Color, colors, this->PointIds[i]);
      }
    });
  this->FindUpperQuartile(vertices);
  this->BuildClusters(vertices);
  return vertices;
}

//------------------------------------------------------------------------------
void PointSprites::SortIds(vtkDataArray* points, const double bounds[6])
{
  MortonCodes codes;
  if (!vtkArrayDispatch::DispatchByValueType<vtkArrayDispatch::Reals>::Execute(
        points, codes, bounds))
  {
    codes(points, bounds);
  }
  vtkSMPTools::Sort(codes.Codes.begin(), codes.Codes.end());
  vtkSMPTools::For(0, static_cast<vtkIdType>(codes.Codes.size()),
    [&](vtkIdType begin, vtkIdType end)
    {
      for (vtkIdType i = begin; i < end; ++i)
      {
        this->PointIds[i] = codes.Codes[i].second;
      }
    });
}

//------------------------------------------------------------------------------
void PointSprites::FindUpperQuartile(const std::vector<SpriteVertex>& vertices)
{
  const vtkIdType count = static_cast<vtkIdType>(vertices.size());
  std::vector<float> radii;
  for (vtkIdType i = 0; i < count; i += 1 + count / 4096)
  {
    radii.push_back(vertices[i].Radius);
  }
  if (!radii.empty())
  {
    const auto quartile = radii.begin() + 3 * radii.size() / 4;
    std::nth_element(radii.begin(), quartile, radii.end());
    this->UpperQuartileRadius = *quartile;
  }
}

//------------------------------------------------------------------------------
void PointSprites::BuildClusters(const std::vector<SpriteVertex>& vertices)
{
  const vtkIdType count = static_cast<vtkIdType>(vertices.size());
  this->Clusters.resize((count + ClusterSize - 1) / ClusterSize);
  vtkSMPTools::For(0, static_cast<vtkIdType>(this->Clusters.size()),
    [&](vtkIdType begin, vtkIdType end)
    {
      for (vtkIdType b = begin; b < end; ++b)
      {
        SphereCluster& cluster = this->Clusters[b];
        cluster.Begin = b * ClusterSize;
        cluster.End = std::min(cluster.Begin + ClusterSize, count);
        cluster.MaximumRadius = 0.0;
        vtkBoundingBox box;
        for (vtkIdType i = cluster.Begin; i < cluster.End; ++i)
        {
          const SpriteVertex& v = vertices[i];
          const double r = v.Radius;
          cluster.MaximumRadius = std::max(cluster.MaximumRadius, r);
          const double c[3] = { this->Origin[0] + v.CenterHigh[0] + v.CenterLow[0],
            this->Origin[1] + v.CenterHigh[1] + v.CenterLow[1],
            this->Origin[2] + v.CenterHigh[2] + v.CenterLow[2] };
          const double bounds[6] = { c[0] - r, c[0] + r, c[1] - r, c[1] + r, c[2] - r, c[2] + r };
          box.AddBounds(bounds);
        }
        box.GetBounds(cluster.Bounds.data());
      }
    });
}
}
