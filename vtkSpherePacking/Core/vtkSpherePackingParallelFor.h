// SPDX-License-Identifier: BSD-3-Clause
// vtkSMPTools for the kernels. Private to the module.
#ifndef vtkSpherePackingParallelFor_h
#define vtkSpherePackingParallelFor_h

#include "kernels/BuildBvh.h"

#include "vtkSMPTools.h"

#include <algorithm>
#include <atomic>

VTK_ABI_NAMESPACE_BEGIN
// Each thread takes the next piece of work when it has done one. vtkSMPTools may share the pieces
// out beforehand, and then waits for whichever thread is the slowest.
inline spherepacking::ParallelFor vtkSpherePackingParallelFor()
{
  return [](std::int64_t count, const std::function<void(std::int64_t)>& work)
  {
    std::atomic<std::int64_t> next{ 0 };
    const vtkIdType threads =
      std::min<std::int64_t>(count, std::max(1, vtkSMPTools::GetEstimatedNumberOfThreads()));
    vtkSMPTools::For(0, threads, 1,
      [&](vtkIdType, vtkIdType)
      {
        for (std::int64_t i = next++; i < count; i = next++)
        {
          work(i);
        }
      });
  };
}
VTK_ABI_NAMESPACE_END

#endif
