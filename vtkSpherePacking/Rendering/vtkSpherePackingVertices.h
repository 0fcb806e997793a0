// SPDX-License-Identifier: BSD-3-Clause
// The spheres as the vertex shader reads them. Private to the module.
#ifndef vtkSpherePackingVertices_h
#define vtkSpherePackingVertices_h

#include "vtkABINamespace.h"
#include "vtkType.h"

#include <array>
#include <vector>

VTK_ABI_NAMESPACE_BEGIN
class vtkDataArray;
class vtkPolyData;
class vtkUnsignedCharArray;

struct vtkSpherePackingVertex
{
  // The centre relative to the origin is high + low, precise to 48 bits.
  float High[3];
  float Low[3];
  float Radius;
  unsigned char Color[4];
};

// The colour of a point as RGBA bytes, white when `colors` is null. Like VTK's colours these have
// 1 to 4 components: luminance, luminance and alpha, RGB or RGBA.
void vtkSpherePackingFillColor(unsigned char rgba[4], vtkUnsignedCharArray* colors, vtkIdType id);

// The low 32 bits of a point's id, lowest byte first.
void vtkSpherePackingFillId(unsigned char bytes[4], vtkIdType id);

// A run of vertices and the box around their spheres, in data coordinates.
struct vtkSpherePackingBlock
{
  vtkIdType Begin;
  vtkIdType End;
  std::array<double, 6> Bounds;
  double MaximumRadius;
};

class vtkSpherePackingVertices
{
public:
  // One vertex a sphere, neighbours in space near each other. `colors` may be null or have one
  // tuple of 1 to 4 components a point.
  std::vector<vtkSpherePackingVertex> Build(
    vtkPolyData* packing, vtkDataArray* radii, vtkUnsignedCharArray* colors);

  const std::array<double, 3>& GetOrigin() const { return this->Origin; }
  // The point that each vertex was made from.
  const std::vector<vtkIdType>& GetPointIds() const { return this->PointIds; }
  const std::vector<vtkSpherePackingBlock>& GetBlocks() const { return this->Blocks; }
  // A radius that three of four spheres do not exceed.
  double GetUsualRadius() const { return this->UsualRadius; }

private:
  void SortIds(vtkDataArray* points, const double bounds[6]);
  void BuildBlocks(const std::vector<vtkSpherePackingVertex>& vertices);

  std::array<double, 3> Origin{ 0.0, 0.0, 0.0 };
  std::vector<vtkIdType> PointIds;
  std::vector<vtkSpherePackingBlock> Blocks;
  double UsualRadius = 0.0;
};
VTK_ABI_NAMESPACE_END

#endif
