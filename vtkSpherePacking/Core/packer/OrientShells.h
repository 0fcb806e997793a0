// SPDX-License-Identifier: BSD-3-Clause
#ifndef OrientShells_h
#define OrientShells_h

#include "packer/SurfaceMesh.h"

#include <functional>

namespace spherepacking
{
/// Turns the triangles of a surface without open edges outwards.
///
/// Triangles that share an edge with no third one are turned alike and make a patch. Patches that
/// share an edge make a shell, unless they are closed by themselves. A shell is turned so that it
/// bounds what is inside of it; one that lies within an odd number of others bounds a hole.
///
/// Asks `goOn` again and again. If that says no, the triangles are left as they are by then, and
/// the result is false.
bool OrientShells(SurfaceMesh& mesh, const std::function<bool()>& goOn);
}

#endif
