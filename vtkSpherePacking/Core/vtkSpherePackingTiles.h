// SPDX-License-Identifier: BSD-3-Clause
// The loop over the tiles of a picture. Private to the module.
#ifndef vtkSpherePackingTiles_h
#define vtkSpherePackingTiles_h

#include "kernels/TraceTile.h"

#include "vtkABINamespace.h"

#include <functional>
#include <vector>

VTK_ABI_NAMESPACE_BEGIN
struct vtkSpherePackingTiles
{
  std::vector<spherepacking::Tile> Tiles; // row by row from the bottom
  std::vector<double> ComputeSeconds;     // of each tile; 0 for those that were not made
  std::vector<double> PartialSeconds;     // from a tile's begin until it has been reported
  double CompleteSeconds = 0.0;

  // Cuts a picture into tiles; those at the right and at the top may be smaller.
  vtkSpherePackingTiles(const int (&window)[2], const int (&tile)[2]);

  // Makes the tiles on all cores. `report` is called after each, in the calling thread, with the
  // part of them that is done, and says whether to stop. Returns the tiles that were not begun.
  std::vector<spherepacking::Tile> Run(const std::function<void(const spherepacking::Tile&)>& make,
    const std::function<bool(double)>& report);
};
VTK_ABI_NAMESPACE_END

#endif
