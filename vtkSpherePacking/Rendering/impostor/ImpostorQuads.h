// SPDX-License-Identifier: BSD-3-Clause
/// Impostor quads: two triangles around the outline of each sphere that a point sprite cannot show.
#ifndef ImpostorQuads_h
#define ImpostorQuads_h

#include "impostor/PointSprites.h"
#include "impostor/ViewTransform.h"

#include <vector>

namespace spherepacking
{
/// All but the corner is the same in the six vertices of a quad; RaySphereFS.glsl explains it.
struct QuadVertex
{
  float Corner[3]; ///< in normalized device coordinates
  float Reference[4];
  float ReferenceLow[2];
  float Shape[4];
  float ShapeLow[4];
  float EyePower[2];
  unsigned char Color[4];
  unsigned char Id[4];
};

/// Up to this radius, as a fraction of the depth range, single precision is enough for a depth
/// buffer of 24 bits; RaySphereFS.glsl has the derivation.
constexpr float MaximumDepthFraction = 0.05f;

/// Makes six vertices for each sphere in the view volume that PointSpriteVS.glsl rejects: one whose
/// point would be larger than `maximumPointSize` pixels, whose depths need double precision, or
/// that lies within four radii of the eye.
///
/// Centres and radii are read from the packing itself, in its own precision: the distance of the
/// eye to a near surface is a difference that loses its digits in single precision.
std::vector<QuadVertex> MakeImpostorQuads(vtkPolyData* packing, vtkDataArray* radii,
  vtkUnsignedCharArray* colors, const PointSprites& sprites, const ViewTransform& view,
  double maximumPointSize);
}

#endif
