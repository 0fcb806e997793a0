// SPDX-License-Identifier: BSD-3-Clause
/// What makes a closed surface of one that a file holds.
///
/// Triangles are duplicates if they have the same three points, however oriented. Two duplicates
/// are a double-sided facet, a wall without thickness, of which a solid may have some inside:
/// spheres do not cross it, though it bounds no volume.
///
/// VTK's vtkStaticCleanPolyData merges points and vtkFeatureEdges finds edges that one triangle or
/// more than two have; neither removes duplicates, nor does either tell an odd number of triangles
/// at an edge, where the surface is open, from an even one.
#ifndef RepairMesh_h
#define RepairMesh_h

#include "packer/SurfaceMesh.h"

namespace spherepacking
{
/// Merges points of equal coordinates, see MergePoints().
void MergeCoincidentPoints(SurfaceMesh& mesh);

/// Replaces the points of triangles, point i by point others[i], and removes triangles that have
/// become degenerate. Keeps one of an odd number of duplicates, oriented as the majority; keeps two
/// of an even number, a possible double-sided facet, unless every triangle of the mesh has an even
/// number: then one.
void MergePoints(SurfaceMesh& mesh, const std::vector<std::int32_t>& others);

/// Takes the double-sided facets out of a mesh, and returns one triangle of each; does nothing if
/// there is no other triangle.
std::vector<Triangle> TakeDoubleSided(SurfaceMesh& mesh);

/// Makes double-sided facets single where an edge is open, and from there on those that share an
/// edge with one that has become single.
void DropDuplicates(SurfaceMesh& mesh);
}

#endif
