// SPDX-License-Identifier: BSD-3-Clause
#include "vtkSpherePackingTiles.h"

#include "vtkSpherePackingPieces.h"

#include <algorithm>
#include <chrono>

VTK_ABI_NAMESPACE_BEGIN
namespace
{
using Clock = std::chrono::steady_clock;
using Seconds = std::chrono::duration<double>;
}

//------------------------------------------------------------------------------
vtkSpherePackingTiles::vtkSpherePackingTiles(const int (&window)[2], const int (&tile)[2])
{
  for (std::int64_t y = 0; y < window[1]; y += tile[1])
  {
    for (std::int64_t x = 0; x < window[0]; x += tile[0])
    {
      const int left = static_cast<int>(x);
      const int bottom = static_cast<int>(y);
      this->Tiles.push_back({ left, bottom, std::min(tile[0], window[0] - left),
        std::min(tile[1], window[1] - bottom) });
    }
  }
  this->ComputeSeconds.assign(this->Tiles.size(), 0.0);
  this->PartialSeconds.assign(this->Tiles.size(), 0.0);
}

//------------------------------------------------------------------------------
std::vector<spherepacking::Tile> vtkSpherePackingTiles::Run(
  const std::function<void(const spherepacking::Tile&)>& make,
  const std::function<bool(double)>& report)
{
  const Clock::time_point start = Clock::now();
  std::vector<Clock::time_point> begun(this->Tiles.size());
  const std::vector<char> made = vtkSpherePackingMakePieces(
    static_cast<std::int64_t>(this->Tiles.size()),
    [&](std::int64_t i)
    {
      begun[i] = Clock::now();
      make(this->Tiles[i]);
      this->ComputeSeconds[i] = Seconds(Clock::now() - begun[i]).count();
    },
    [&](std::int64_t i, double share)
    {
      const bool stop = report(share);
      this->PartialSeconds[i] = Seconds(Clock::now() - begun[i]).count();
      return stop;
    });
  this->CompleteSeconds = Seconds(Clock::now() - start).count();
  std::vector<spherepacking::Tile> left;
  for (std::size_t i = 0; i < this->Tiles.size(); ++i)
  {
    if (!made[i])
    {
      left.push_back(this->Tiles[i]);
    }
  }
  return left;
}
VTK_ABI_NAMESPACE_END
