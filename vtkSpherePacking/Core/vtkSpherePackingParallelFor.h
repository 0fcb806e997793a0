// SPDX-License-Identifier: BSD-3-Clause
// vtkSMPTools for the kernels. Private to the module.
#ifndef vtkSpherePackingParallelFor_h
#define vtkSpherePackingParallelFor_h

#include "kernels/BuildBvh.h"

#include "vtkSMPTools.h"

VTK_ABI_NAMESPACE_BEGIN
// One piece of work at a time, since some take longer than others.
inline spherepacking::ParallelFor vtkSpherePackingParallelFor()
{
  return [](std::int64_t count, const std::function<void(std::int64_t)>& work)
  {
    vtkSMPTools::For(0, static_cast<vtkIdType>(count), 1,
      [&work](vtkIdType first, vtkIdType last)
      {
        for (vtkIdType i = first; i < last; ++i)
        {
          work(i);
        }
      });
  };
}
VTK_ABI_NAMESPACE_END

#endif
