// SPDX-License-Identifier: BSD-3-Clause
#include "bridge/RunInterruptibly.h"

#include "bridge/SmpParallelFor.h"

#include "vtkAlgorithm.h"

#include <chrono>
#include <future>
#include <system_error>

namespace spherepacking
{
//------------------------------------------------------------------------------
void RunInterruptibly(vtkAlgorithm* algorithm, std::int64_t spheres,
  const std::function<void(std::atomic<double>& done)>& work)
{
  constexpr std::int64_t FewSpheres = 10'000;
  // How long Ctrl-C is not heard at most.
  constexpr std::chrono::milliseconds pause(20);
  std::atomic<double> done{ algorithm->GetProgress() };
  std::atomic<bool> stop{ false };
  const auto ask = [&]
  {
    algorithm->UpdateProgress(done);
    if (algorithm->CheckAbort())
    {
      stop = true;
    }
  };
  ask();
  if (spheres < FewSpheres)
  {
    const StoppedBy scope(stop);
    work(done);
    return;
  }
  std::future<void> worker;
  try
  {
    worker = std::async(std::launch::async,
      [&]
      {
        const StoppedBy scope(stop);
        work(done);
      });
  }
  catch (const std::system_error&)
  {
    work(done); // the system gives no more threads
    return;
  }
  while (worker.wait_for(pause) == std::future_status::timeout)
  {
    ask();
  }
  worker.get();
}
}
