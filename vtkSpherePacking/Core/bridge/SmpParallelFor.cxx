// SPDX-License-Identifier: BSD-3-Clause
#include "bridge/SmpParallelFor.h"

#include "vtkSMPTools.h"

#include <algorithm>
#include <atomic>
#include <exception>
#include <mutex>
#ifdef __SANITIZE_THREAD__
#include <thread>
#include <vector>
#endif

namespace spherepacking
{
namespace
{
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

// An exception that left a thread's function would end the process.
class FirstException
{
public:
  void Catch()
  {
    const std::lock_guard<std::mutex> lock(this->Mutex);
    if (!this->Exception)
    {
      this->Exception = std::current_exception();
    }
  }

  void Rethrow() const
  {
    if (this->Exception)
    {
      std::rethrow_exception(this->Exception);
    }
  }

private:
  std::mutex Mutex;
  std::exception_ptr Exception;
};
}

//------------------------------------------------------------------------------
ParallelFor SmpParallelFor()
{
  return [](std::int64_t count, const std::function<void(std::int64_t)>& work)
  {
    // Each thread takes the next piece of work when it has done one: vtkSMPTools may share the
    // pieces out beforehand, and then waits for whichever thread is the slowest.
    std::atomic<std::int64_t> next{ 0 };
    FirstException first;
    const vtkIdType threads =
      std::min<std::int64_t>(count, std::max(1, vtkSMPTools::GetEstimatedNumberOfThreads()));
    RunOnThreads(threads,
      [&]
      {
        try
        {
          for (std::int64_t i = next++; i < count; i = next++)
          {
            work(i);
          }
        }
        catch (...)
        {
          first.Catch();
          next = count;
        }
      });
    first.Rethrow();
  };
}
}
