// SPDX-License-Identifier: BSD-3-Clause
#include "bridge/SmpParallelFor.h"

#include "bridge/Guard.h"

#include <algorithm>
#include <utility>
#ifdef __SANITIZE_THREAD__
#include <thread>
#include <vector>
#endif

namespace spherepacking
{
namespace
{
thread_local const std::atomic<bool>* StopFlag = nullptr;

// Runs `body` on so many threads at once.
template <typename Body>
void RunOnThreads(std::int64_t threads, const Body& body)
{
#ifdef __SANITIZE_THREAD__
  // The thread sanitizer does not see how the threads of VTK, which it was not built into, wait for
  // each other, and would call every result a data race.
  std::vector<std::thread> others;
  for (std::int64_t i = 0; i < std::max<std::int64_t>(threads, 4); ++i)
  {
    others.emplace_back(body);
  }
  for (std::thread& other : others)
  {
    other.join();
  }
#else
  vtkSMPTools::For(0, threads, 1, [&](vtkIdType, vtkIdType) { body(); });
#endif
}
}

//------------------------------------------------------------------------------
StoppedBy::StoppedBy(const std::atomic<bool>& stop)
  : Before(std::exchange(StopFlag, &stop))
{
}

//------------------------------------------------------------------------------
StoppedBy::~StoppedBy()
{
  StopFlag = this->Before;
}

//------------------------------------------------------------------------------
ParallelFor SmpParallelFor()
{
  return [](std::int64_t count, const std::function<void(std::int64_t)>& work)
  {
    const std::atomic<bool>* const stop = StopFlag;
    // Each thread takes the next piece of work when it has done one: vtkSMPTools may share the
    // pieces out beforehand, and then waits for whichever thread is the slowest.
    std::atomic<std::int64_t> next{ 0 };
    const vtkIdType threads =
      std::min<std::int64_t>(count, std::max(1, vtkSMPTools::GetEstimatedNumberOfThreads()));
    FirstException first;
    RunOnThreads(threads,
      [&]
      {
        try
        {
          for (std::int64_t i = next++; i < count; i = next++)
          {
            if (stop && stop->load(std::memory_order_relaxed))
            {
              throw AbortRequest();
            }
            work(i);
          }
        }
        catch (...)
        {
          next = count;
          first.Catch();
        }
      });
    first.Rethrow();
  };
}
}
