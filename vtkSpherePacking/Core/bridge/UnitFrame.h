// SPDX-License-Identifier: BSD-3-Clause
#ifndef UnitFrame_h
#define UnitFrame_h

#include "packer/ClearanceTree.h"

class vtkPolyData;

namespace spherepacking
{
/// The coordinates that a surface is packed in, about 1 long and around the origin: one far away
/// loses no digits on the way, and one very large or small stays in the range of single precision.
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
