// SPDX-License-Identifier: BSD-3-Clause
#include "bridge/UnitFrame.h"

#include "bridge/PackingArrays.h"

#include "vtkPolyData.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace spherepacking
{
//------------------------------------------------------------------------------
UnitFrame::UnitFrame(const SurfaceMesh& mesh)
{
  const MeshBounds bounds = BoundsOf(mesh);
  const double longest = bounds.LongestSide();
  this->Origin = bounds.Center();
  this->Scale = longest > 0.0 ? std::exp2(std::round(std::log2(longest))) : 1.0;
}

//------------------------------------------------------------------------------
double UnitFrame::Rounding() const
{
  const double farthest = std::max(
    std::max(std::abs(this->Origin.X), std::abs(this->Origin.Y)), std::abs(this->Origin.Z));
  return 2.0 * std::numeric_limits<double>::epsilon() * (farthest + this->Scale);
}

//------------------------------------------------------------------------------
void UnitFrame::Normalize(SurfaceMesh& mesh) const
{
  for (Vector3& point : mesh.Points)
  {
    point = (1.0 / this->Scale) * (point - this->Origin);
  }
}

//------------------------------------------------------------------------------
void UnitFrame::Write(const std::vector<PackedSphere>& spheres, vtkPolyData* output) const
{
  PackingArrays arrays(static_cast<vtkIdType>(spheres.size()), false);
  double* centers = arrays.Centers<double>();
  double* radii = arrays.Radii<double>();
  for (const PackedSphere& sphere : spheres)
  {
    for (int axis = 0; axis < 3; ++axis)
    {
      *centers++ = this->Origin[axis] + this->Scale * sphere.Center[axis];
    }
    *radii++ = this->Scale * sphere.Radius - this->Rounding();
  }
  arrays.MoveTo(output);
}
}
