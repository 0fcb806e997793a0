// SPDX-License-Identifier: BSD-3-Clause
#ifndef Progress_h
#define Progress_h

#include "bridge/SmpParallelFor.h"
#include "io/PackingFileError.h"

#include "vtkAlgorithm.h"
#include "vtkSMPTools.h"

#include <algorithm>

namespace spherepacking
{
/**
 * Reports the progress of an algorithm and checks for an abort. Used only in the thread that runs
 * the algorithm, since that is where observers may be called.
 */
class Progress
{
public:
  /// Without an algorithm, Report() does nothing.
  explicit Progress(vtkAlgorithm* algorithm)
    : Algorithm(algorithm)
  {
  }

  /// Sets the range of the overall progress, within 0 to 1, that the following reports cover.
  void SetRange(double from, double to)
  {
    this->From = from;
    this->To = to;
  }

  /// Reports that `fraction` of the current range is done. Throws an AbortRequest if an observer
  /// asked for an abort.
  void Report(double fraction)
  {
    if (!this->Algorithm)
    {
      return;
    }
    this->Algorithm->UpdateProgress(this->From + fraction * (this->To - this->From));
    if (this->Algorithm->CheckAbort())
    {
      throw AbortRequest();
    }
  }

private:
  vtkAlgorithm* Algorithm;
  double From = 0.0;
  double To = 1.0;
};

/**
 * A parallel loop with progress: calls body(first, last) on chunks of `grain` of [0, count), in
 * batches of 32 chunks per thread, and after each batch check() and Report() in the calling thread.
 * `body` must not throw, `check` may.
 */
template <typename Body, typename Check>
void ForInBatches(
  vtkIdType count, vtkIdType grain, Progress& progress, const Body& body, const Check& check)
{
  const vtkIdType batch = grain * 32 * std::max(1, vtkSMPTools::GetEstimatedNumberOfThreads());
  for (vtkIdType first = 0; first < count; first += batch)
  {
    const vtkIdType last = std::min(count, first + batch);
    SmpFor(first, last, grain, body);
    check();
    progress.Report(static_cast<double>(last) / static_cast<double>(count));
  }
}
}

#endif
