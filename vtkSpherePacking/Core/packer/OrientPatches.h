// SPDX-License-Identifier: BSD-3-Clause
#ifndef OrientPatches_h
#define OrientPatches_h

#include "packer/EdgeTable.h"

namespace spherepacking
{
using TriangleIds = std::vector<std::int32_t>;

/// Orients triangles consistently across each edge that exactly two of them share; of each patch
/// that is connected by such edges, those of the smaller area are flipped. Returns the patches.
/// Throws a std::invalid_argument if one is not orientable, as a Moebius strip.
std::vector<TriangleIds> OrientPatches(SurfaceMesh& mesh, const EdgeTable& edges);

/// Orients a patch of a closed shell outwards: from an outward side, a ray crosses an even number
/// of the shell's other triangles. Rays from all over the patch vote, since one may hit an edge.
/// Source: Takayama, Jacobson, Kavan and Sorkine-Hornung, "A simple method for correcting facet
/// orientations in polygon meshes based on ray casting" (2014).
void OrientByRays(SurfaceMesh& mesh, const TriangleIds& shell, const TriangleIds& patch);
}

#endif
