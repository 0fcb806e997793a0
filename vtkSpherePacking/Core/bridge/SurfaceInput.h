// SPDX-License-Identifier: BSD-3-Clause
#ifndef SurfaceInput_h
#define SurfaceInput_h

#include "packer/SurfaceMesh.h"

class vtkPolyData;

namespace spherepacking
{
/// Triangulates the polygons and strips of a surface, leaves out other cells, and merges coincident
/// points.
///
/// Where edges are open it repairs as little as possible: first it makes double-sided facets single
/// there, then it merges points that are nearly the same, then it does both. Throws a
/// std::invalid_argument that says where the surface is open if that does not close it, or if
/// there are no triangles, too many, or points that are missing or not finite.
SurfaceMesh ClosedMeshOf(vtkPolyData* surface);
}

#endif
