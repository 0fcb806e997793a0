// SPDX-License-Identifier: BSD-3-Clause
#ifndef UnitFrame_h
#define UnitFrame_h

#include "packer/ClearanceTree.h"

class vtkPolyData;

namespace spherepacking
{
/// Normalised coordinates, in which a surface is about 1 long and around the origin. So one that is
/// far away loses no digits in differences, and one that is very large or small stays in the range
/// of single precision.
class UnitFrame
{
public:
  explicit UnitFrame(const SurfaceMesh& mesh);

  /// The length 1 in the unit of the surface, a power of two, so that scaling is exact.
  double Unit() const { return this->Scale; }

  /// How far rounding may move a point between the two, in the unit of the surface.
  double Rounding() const;

  /// Brings a surface into this frame.
  void Normalize(SurfaceMesh& mesh) const;

  /// Writes spheres of this frame as a packing in the unit of the surface, smaller by Rounding().
  void Write(const std::vector<PackedSphere>& spheres, vtkPolyData* output) const;

private:
  Vector3 Origin;
  double Scale;
};
}

#endif
