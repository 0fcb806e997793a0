// SPDX-License-Identifier: BSD-3-Clause
#ifndef SmpParallelFor_h
#define SmpParallelFor_h

#include "base/ParallelFor.h"

#include "vtkSMPTools.h"

#include <atomic>
#include <exception>
#include <mutex>

namespace spherepacking
{
/// The threads of vtkSMPTools for those who know no VTK. The first exception that leaves the work
/// is thrown again in the calling thread, when all threads are done; no work is begun after it.
ParallelFor SmpParallelFor();

/// While it lives, loops of SmpParallelFor() that are called from this thread throw an AbortRequest
/// as soon as `stop` is true.
class StoppedBy
{
public:
  explicit StoppedBy(const std::atomic<bool>& stop);
  StoppedBy(const StoppedBy&) = delete;
  void operator=(const StoppedBy&) = delete;
  ~StoppedBy();

private:
  const std::atomic<bool>* Before;
};

/// Carries the first exception of several threads to the one that waits for them: one that left a
/// thread's function would end the process.
class FirstException
{
public:
  /// To be called where an exception is caught.
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

/// vtkSMPTools::For() of pieces [begin, end) of [first, last), of `grain` each or of as many as VTK
/// chooses for 0, whose first exception is thrown again in the calling thread.
template <typename Body>
void SmpFor(vtkIdType first, vtkIdType last, vtkIdType grain, const Body& body)
{
  FirstException exception;
  vtkSMPTools::For(first, last, grain,
    [&](vtkIdType begin, vtkIdType end)
    {
      try
      {
        body(begin, end);
      }
      catch (...)
      {
        exception.Catch();
      }
    });
  exception.Rethrow();
}
}

#endif
