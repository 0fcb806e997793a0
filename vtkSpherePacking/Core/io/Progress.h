// SPDX-License-Identifier: BSD-3-Clause
#ifndef Progress_h
#define Progress_h

#include "io/PackingFileError.h"

#include "vtkAlgorithm.h"
#include "vtkSMPTools.h"

#include <algorithm>

namespace spherepacking
{
/**
 * Reports how far an algorithm is and asks whether it has to stop. Used only in the thread that
 * runs the algorithm, since that is where observers may be called.
 */
class Progress
{
public:
  /// Without an algorithm nobody is told and nobody asks to stop.
  explicit Progress(vtkAlgorithm* algorithm)
    : Algorithm(algorithm)
  {
  }

  /// The part of the whole, from 0 to 1, that the following steps make up.
  void SetRange(double from, double to)
  {
    this->From = from;
    this->To = to;
  }

  /// `fraction` of the current range is done. Throws an AbortRequest when asked to stop.
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
 * Calls body(first, last) on parts of [0, count) in all threads, some 32 times `grain` of them a
 * thread at a time, and between these check() and a report in the calling thread. `body` must not
 * throw, `check` may.
 */
template <typename Body, typename Check>
void ForInBatches(
  vtkIdType count, vtkIdType grain, Progress& progress, const Body& body, const Check& check)
{
  const vtkIdType batch = grain * 32 * std::max(1, vtkSMPTools::GetEstimatedNumberOfThreads());
  for (vtkIdType first = 0; first < count; first += batch)
  {
    const vtkIdType last = std::min(count, first + batch);
    vtkSMPTools::For(first, last, grain, body);
    check();
    progress.Report(static_cast<double>(last) / static_cast<double>(count));
  }
}
}

#endif
