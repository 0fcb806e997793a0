// SPDX-License-Identifier: BSD-3-Clause
// Spheres that are too near or too large for one point each. Private to the module.
#ifndef vtkSpherePackingQuads_h
#define vtkSpherePackingQuads_h

#include "vtkABINamespace.h"
#include "vtkSpherePackingVertices.h"
#include "vtkSpherePackingView.h"

#include <vector>

VTK_ABI_NAMESPACE_BEGIN
struct vtkSpherePackingQuadVertex
{
  float Corner[3];
  float Reference[4];
  float Shape[4];
  float ShapeLow[4];
  float Rest[4];
  unsigned char Color[4];
  unsigned char Id[4];
};

// Up to this share of the depth buffer for one radius, float arithmetic is precise enough for a
// depth buffer of 24 bits; see vtkSpherePackingFSDeclarations.glsl.
constexpr float vtkSpherePackingMaximumDepthShare = 0.05f;

// Six vertices, two triangles, for every sphere in the view volume that vtkSpherePackingVS.glsl
// leaves out: because a point would be larger than `maximumPointSize` pixels, because its depths
// need double precision, or because it lies within four radii of the eye. The spheres come from
// the packing itself, in its own precision: the distance of the eye to a near surface is a
// difference that float would lose.
std::vector<vtkSpherePackingQuadVertex> vtkSpherePackingMakeQuads(vtkPolyData* packing,
  vtkDataArray* radii, vtkUnsignedCharArray* colors, const vtkSpherePackingVertices& vertices,
  const vtkSpherePackingView& view, double maximumPointSize);
VTK_ABI_NAMESPACE_END

#endif
