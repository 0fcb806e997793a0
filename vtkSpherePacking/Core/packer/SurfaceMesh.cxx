// SPDX-License-Identifier: BSD-3-Clause
#include "packer/SurfaceMesh.h"

#include <algorithm>

namespace spherepacking
{
//------------------------------------------------------------------------------
double SurfaceMesh::Volume() const
{
  if (this->Points.empty())
  {
    return 0.0;
  }
  // From one of the points: far from the origin, differences of large products would lose digits.
  const Vector3 origin = this->Points.front();
  double sum = 0.0;
  for (const Triangle& triangle : this->Triangles)
  {
    sum += Dot(this->Corner(triangle, 0) - origin,
      Cross(this->Corner(triangle, 1) - origin, this->Corner(triangle, 2) - origin));
  }
  return sum / 6.0;
}

//------------------------------------------------------------------------------
double MeshBounds::LongestSide() const
{
  const Vector3 size = this->High - this->Low;
  return std::max(std::max(size.X, size.Y), size.Z);
}

//------------------------------------------------------------------------------
bool MeshBounds::Contains(const MeshBounds& other) const
{
  for (int axis = 0; axis < 3; ++axis)
  {
    if (other.Low[axis] < this->Low[axis] || other.High[axis] > this->High[axis])
    {
      return false;
    }
  }
  return true;
}

//------------------------------------------------------------------------------
MeshBounds BoundsOf(const SurfaceMesh& mesh)
{
  const Vector3 first = mesh.Corner(mesh.Triangles.front(), 0);
  MeshBounds bounds{ first, first };
  for (const Triangle& triangle : mesh.Triangles)
  {
    for (int corner = 0; corner < 3; ++corner)
    {
      const Vector3 point = mesh.Corner(triangle, corner);
      for (int axis = 0; axis < 3; ++axis)
      {
        bounds.Low[axis] = std::min(bounds.Low[axis], point[axis]);
        bounds.High[axis] = std::max(bounds.High[axis], point[axis]);
      }
    }
  }
  return bounds;
}
}
