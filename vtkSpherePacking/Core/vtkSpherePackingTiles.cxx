// SPDX-License-Identifier: BSD-3-Clause
#include "vtkSpherePackingTiles.h"

#include "vtkSpherePackingParallelFor.h"

#include <algorithm>
#include <atomic>
#include <chrono>
#include <condition_variable>
#include <future>
#include <mutex>

VTK_ABI_NAMESPACE_BEGIN
namespace
{
using Clock = std::chrono::steady_clock;
using Seconds = std::chrono::duration<double>;

// Tiles that are made, handed from the threads that make them to the one that reports them.
class Finished
{
public:
  void Add(std::size_t tile)
  {
    const std::lock_guard<std::mutex> lock(this->Mutex);
    this->Tiles.push_back(tile);
    this->Changed.notify_one();
  }

  void AddNoMore()
  {
    const std::lock_guard<std::mutex> lock(this->Mutex);
    this->Last = true;
    this->Changed.notify_one();
  }

  // Waits for some; none when there are no more.
  std::vector<std::size_t> Take()
  {
    std::unique_lock<std::mutex> lock(this->Mutex);
    this->Changed.wait(lock, [this] { return this->Last || !this->Tiles.empty(); });
    return std::exchange(this->Tiles, {});
  }

private:
  std::mutex Mutex;
  std::condition_variable Changed;
  std::vector<std::size_t> Tiles;
  bool Last = false;
};
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
  std::vector<char> made(this->Tiles.size(), 0);
  std::atomic<bool> stop{ false };
  Finished finished;
  // Observers are to be called in this thread, which therefore makes no tiles.
  const std::future<void> makers = std::async(std::launch::async,
    [&]
    {
      vtkSpherePackingParallelFor()(static_cast<std::int64_t>(this->Tiles.size()),
        [&](std::int64_t i)
        {
          if (!stop)
          {
            begun[i] = Clock::now();
            make(this->Tiles[i]);
            this->ComputeSeconds[i] = Seconds(Clock::now() - begun[i]).count();
            made[i] = 1;
            finished.Add(static_cast<std::size_t>(i));
          }
        });
      finished.AddNoMore();
    });
  std::size_t number = 0;
  for (auto some = finished.Take(); !some.empty(); some = finished.Take())
  {
    for (const std::size_t i : some)
    {
      ++number;
      if (report(static_cast<double>(number) / static_cast<double>(this->Tiles.size())))
      {
        stop = true;
      }
      this->PartialSeconds[i] = Seconds(Clock::now() - begun[i]).count();
    }
  }
  makers.wait();
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
