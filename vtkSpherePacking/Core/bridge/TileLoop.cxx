// SPDX-License-Identifier: BSD-3-Clause
#include "bridge/TileLoop.h"

#include "bridge/Guard.h"
#include "bridge/InterruptibleFor.h"

#include <algorithm>

namespace spherepacking
{
//------------------------------------------------------------------------------
TileLoop::TileLoop(const int (&window)[2], const int (&tile)[2])
{
  for (std::int64_t y = 0; y < window[1]; y += tile[1])
  {
    for (std::int64_t x = 0; x < window[0]; x += tile[0])
    {
      const int x0 = static_cast<int>(x);
      const int y0 = static_cast<int>(y);
      this->Tiles.push_back(
        { x0, y0, std::min(tile[0], window[0] - x0), std::min(tile[1], window[1] - y0) });
    }
  }
  this->ComputeSeconds.assign(this->Tiles.size(), 0.0);
  this->PartialSeconds.assign(this->Tiles.size(), 0.0);
}

//------------------------------------------------------------------------------
std::vector<Tile> TileLoop::Run(
  const std::function<void(const Tile&)>& make, const std::function<bool(double)>& report)
{
  const Stopwatch whole;
  std::vector<Stopwatch> watches(this->Tiles.size());
  const std::vector<char> made = InterruptibleFor(
    static_cast<std::int64_t>(this->Tiles.size()),
    [&](std::int64_t i)
    {
      watches[i] = Stopwatch();
      make(this->Tiles[i]);
      this->ComputeSeconds[i] = watches[i].Seconds();
    },
    [&](std::int64_t i, double fraction)
    {
      const bool stop = report(fraction);
      this->PartialSeconds[i] = watches[i].Seconds();
      return stop;
    });
  this->CompleteSeconds = whole.Seconds();
  std::vector<Tile> missing;
  for (std::size_t i = 0; i < this->Tiles.size(); ++i)
  {
    if (!made[i])
    {
      missing.push_back(this->Tiles[i]);
    }
  }
  return missing;
}
}
