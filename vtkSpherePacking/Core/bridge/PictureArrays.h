// SPDX-License-Identifier: BSD-3-Clause
// The arrays of a picture that rays make.
#ifndef PictureArrays_h
#define PictureArrays_h

#include "trace/TraceTile.h"

#include <vector>

class vtkDataObject;
class vtkImageData;

namespace spherepacking
{
// Adds the point arrays of a picture to an image that has its size; their values mean nothing yet.
Picture AddPictureArrays(vtkImageData* image);

// The same for the arrays of a picture that paths make.
void AddPathPictureArrays(vtkImageData* image);

// Adds the field array "tile_extents".
void AddTileExtents(vtkDataObject* output, const std::vector<Tile>& tiles);

// Fills a tile with what a ray that hits nothing shows.
void ClearTile(const Picture& picture, const Tile& tile);
}

#endif
