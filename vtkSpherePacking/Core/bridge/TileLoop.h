// SPDX-License-Identifier: BSD-3-Clause
/// The loop over the tiles of a picture.
#ifndef TileLoop_h
#define TileLoop_h

#include "trace/TraceTile.h"

#include <functional>
#include <vector>

namespace spherepacking
{
struct TileLoop
{
  std::vector<Tile> Tiles;            ///< row by row from the bottom
  std::vector<double> ComputeSeconds; ///< of each tile; 0 for those that were not made
  std::vector<double> PartialSeconds; ///< from a tile's begin until it has been reported
  double CompleteSeconds = 0.0;

  /// Cuts a picture into tiles; those at the right and at the top may be smaller.
  TileLoop(const int (&window)[2], const int (&tile)[2]);

  /// Makes the tiles on all cores. `report` is called after each, in the calling thread, with the
  /// fraction of them that is done, and says whether to stop. Returns the tiles that were not made.
  std::vector<Tile> Run(
    const std::function<void(const Tile&)>& make, const std::function<bool(double)>& report);
};
}

#endif
