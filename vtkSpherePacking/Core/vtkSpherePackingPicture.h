// SPDX-License-Identifier: BSD-3-Clause
// The arrays of a picture that rays make. Private to the module.
#ifndef vtkSpherePackingPicture_h
#define vtkSpherePackingPicture_h

#include "kernels/TraceTile.h"

#include "vtkABINamespace.h"

#include <vector>

VTK_ABI_NAMESPACE_BEGIN
class vtkDataObject;
class vtkImageData;

// Adds the point arrays of a picture to an image that has its size; their values mean nothing yet.
spherepacking::Picture vtkSpherePackingAddPicture(vtkImageData* image);

// The same for the arrays of a picture that paths make.
void vtkSpherePackingAddPathPicture(vtkImageData* image);

// Adds the field array "tile_extents".
void vtkSpherePackingAddExtents(
  vtkDataObject* output, const std::vector<spherepacking::Tile>& tiles);

// Fills a tile with what a ray that hits nothing shows.
void vtkSpherePackingShowNothing(
  const spherepacking::Picture& picture, const spherepacking::Tile& tile);
VTK_ABI_NAMESPACE_END

#endif
