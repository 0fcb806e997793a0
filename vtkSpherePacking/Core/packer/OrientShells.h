// SPDX-License-Identifier: BSD-3-Clause
#ifndef OrientShells_h
#define OrientShells_h

#include "packer/SurfaceMesh.h"

#include <functional>

namespace spherepacking
{
/// Orients the triangles of a surface without open edges outwards.
///
/// Triangles that are connected by edges with no third triangle are a patch, see OrientPatches().
/// Patches that share an edge are a shell, but a patch that is closed by itself is a shell of its
/// own. A shell is oriented outwards, away from what it encloses, unless it lies inside an odd
/// number of other shells: then it bounds a hole and is oriented inwards.
///
/// VTK's vtkPolyDataNormals orients closed surfaces without non-manifold edges, which it asks for,
/// and all shells outwards; here edges may be non-manifold and shells may be holes.
///
/// Calls `goOn` again and again. Once that says no, the result is false and the triangles may be
/// oriented either way.
bool OrientShells(SurfaceMesh& mesh, const std::function<bool()>& goOn);
}

#endif
