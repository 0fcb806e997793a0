// SPDX-License-Identifier: BSD-3-Clause
#ifndef RunInterruptibly_h
#define RunInterruptibly_h

#include <atomic>
#include <cstdint>
#include <functional>

class vtkAlgorithm;

namespace spherepacking
{
/// Calls `work` in a thread of its own, while the calling thread lets the algorithm's observers,
/// which belong there, see its progress and to Ctrl-C, again and again. `work` may set how much of
/// it is done, from 0 to 1. Once an observer has asked for an abort, the loops of SmpParallelFor()
/// that `work` runs throw an AbortRequest. An exception that leaves the work is thrown again.
/// With few spheres, for which a thread would take longer than the work, it is done at once.
void RunInterruptibly(vtkAlgorithm* algorithm, std::int64_t spheres,
  const std::function<void(std::atomic<double>& done)>& work);
}

#endif
