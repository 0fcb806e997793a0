// SPDX-License-Identifier: BSD-3-Clause
#include "vtkSpherePackingPieces.h"

#include "vtkSpherePackingParallelFor.h"

#include <atomic>
#include <condition_variable>
#include <future>
#include <mutex>
#include <utility>

VTK_ABI_NAMESPACE_BEGIN
namespace
{
// Pieces that are made, handed from the threads that make them to the one that reports them.
class Finished
{
public:
  void Add(std::int64_t piece)
  {
    const std::lock_guard<std::mutex> lock(this->Mutex);
    this->Pieces.push_back(piece);
    this->Changed.notify_one();
  }

  void AddNoMore()
  {
    const std::lock_guard<std::mutex> lock(this->Mutex);
    this->Last = true;
    this->Changed.notify_one();
  }

  // Waits for some; none when there are no more.
  std::vector<std::int64_t> Take()
  {
    std::unique_lock<std::mutex> lock(this->Mutex);
    this->Changed.wait(lock, [this] { return this->Last || !this->Pieces.empty(); });
    return std::exchange(this->Pieces, {});
  }

private:
  std::mutex Mutex;
  std::condition_variable Changed;
  std::vector<std::int64_t> Pieces;
  bool Last = false;
};
}

//------------------------------------------------------------------------------
std::vector<char> vtkSpherePackingMakePieces(std::int64_t count,
  const std::function<void(std::int64_t)>& make,
  const std::function<bool(std::int64_t, double)>& report)
{
  std::vector<char> made(static_cast<std::size_t>(count), 0);
  std::atomic<bool> stop{ false };
  Finished finished;
  // Observers are to be called in this thread, which therefore makes no pieces.
  const std::future<void> makers = std::async(std::launch::async,
    [&]
    {
      vtkSpherePackingParallelFor()(count,
        [&](std::int64_t i)
        {
          if (!stop)
          {
            make(i);
            made[i] = 1;
            finished.Add(i);
          }
        });
      finished.AddNoMore();
    });
  std::int64_t number = 0;
  for (auto some = finished.Take(); !some.empty(); some = finished.Take())
  {
    for (const std::int64_t i : some)
    {
      ++number;
      if (report(i, static_cast<double>(number) / static_cast<double>(count)))
      {
        stop = true;
      }
    }
  }
  makers.wait();
  return made;
}
VTK_ABI_NAMESPACE_END
