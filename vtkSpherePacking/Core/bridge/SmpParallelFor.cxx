// SPDX-License-Identifier: BSD-3-Clause
#include "bridge/SmpParallelFor.h"

#include "bridge/Guard.h"

#include <algorithm>
#include <utility>

namespace spherepacking
{
namespace
{
thread_local const std::atomic<bool>* StopFlag = nullptr;
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
    SmpFor(0, threads, 1,
      [&](vtkIdType, vtkIdType)
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
          throw;
        }
      });
  };
}
}
