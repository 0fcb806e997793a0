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
#include <numeric>

VTK_ABI_NAMESPACE_BEGIN
namespace
{
constexpr vtkIdType BlockSize = 1024;

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
  std::iota(this->PointIds.begin(), this->PointIds.end(), 0);

  double bounds[6];
  packing->GetPoints()->GetBounds(bounds);
  for (int axis = 0; axis < 3; ++axis)
  {
    this->Origin[axis] = 0.5 * (bounds[2 * axis] + bounds[2 * axis + 1]);
  }

  FillGeometry fill;
  vtkDataArray* points = packing->GetPoints()->GetData();
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
void vtkSpherePackingVertices::BuildBlocks(const std::vector<vtkSpherePackingVertex>& vertices)
{
  const vtkIdType count = static_cast<vtkIdType>(vertices.size());
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
