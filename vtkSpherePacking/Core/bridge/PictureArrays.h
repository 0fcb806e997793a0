// SPDX-License-Identifier: BSD-3-Clause
#ifndef PictureArrays_h
#define PictureArrays_h

#include "trace/TraceTile.h"

#include <vector>

class vtkDataObject;
class vtkImageData;

namespace spherepacking
{
/// Adds the point arrays of a ray-cast picture to an image that has its size; their values are not
/// set yet.
Picture AddPictureArrays(vtkImageData* image);

/// The same for a path-traced picture.
void AddPathPictureArrays(vtkImageData* image);

/// Adds the field array "tile_extents".
void AddTileExtents(vtkDataObject* output, const std::vector<Tile>& tiles);

/// Fills a tile with what a ray that misses shows.
void ClearTile(const Picture& picture, const Tile& tile);
}

#endif
