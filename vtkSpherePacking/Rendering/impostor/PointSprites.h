// SPDX-License-Identifier: BSD-3-Clause
/// The vertices of the point sprites: one per sphere, which PointSpriteVS.glsl makes as large as
/// the sphere's outline.
#ifndef PointSprites_h
#define PointSprites_h

#include "vtkType.h"

#include <array>
#include <vector>

class vtkDataArray;
class vtkPolyData;
class vtkUnsignedCharArray;

namespace spherepacking
{
struct SpriteVertex
{
  /// The center relative to the origin is the sum of both, precise to 47 bits.
  float CenterHigh[3];
  float CenterLow[3];
  float Radius;
  unsigned char Color[4];
};

/// Writes the colour of a point as RGBA, white if `colors` is null. Like VTK's colours these have 1
/// to 4 components: luminance, luminance and alpha, RGB or RGBA.
void PackColor(unsigned char rgba[4], vtkUnsignedCharArray* colors, vtkIdType id);

/// Writes the low 32 bits of a point's id, lowest byte first.
void PackId(unsigned char bytes[4], vtkIdType id);

/// A range of vertices that are near each other in space, which are culled and drawn together.
struct SphereCluster
{
  vtkIdType Begin;
  vtkIdType End;
  std::array<double, 6> Bounds; ///< of the spheres, in data coordinates
  double MaximumRadius;
};

/// The order of the point sprites in their vertex buffer, and their clusters.
class PointSprites
{
public:
  /// Makes one vertex per sphere, in the order of a Morton curve. `colors` may be null or have one
  /// tuple of 1 to 4 components per point.
  std::vector<SpriteVertex> Build(
    vtkPolyData* packing, vtkDataArray* radii, vtkUnsignedCharArray* colors);

  /// The middle of the bounds of the centres: floats are relative to it.
  const std::array<double, 3>& GetOrigin() const { return this->Origin; }

  /// The point of the packing that each vertex was made from.
  const std::vector<vtkIdType>& GetPointIds() const { return this->PointIds; }

  const std::vector<SphereCluster>& GetClusters() const { return this->Clusters; }

  /// Upper quartile of the radii, of a sample of the spheres.
  double GetUpperQuartileRadius() const { return this->UpperQuartileRadius; }

private:
  void SortIds(vtkDataArray* points, const double bounds[6]);
  void FindUpperQuartile(const std::vector<SpriteVertex>& vertices);
  void BuildClusters(const std::vector<SpriteVertex>& vertices);

  std::array<double, 3> Origin{ 0.0, 0.0, 0.0 };
  std::vector<vtkIdType> PointIds;
  std::vector<SphereCluster> Clusters;
  double UpperQuartileRadius = 0.0;
};
}

#endif
