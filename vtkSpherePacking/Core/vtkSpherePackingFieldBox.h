// SPDX-License-Identifier: BSD-3-Clause
// Where a grid has to reach. Private to the module.
#ifndef vtkSpherePackingFieldBox_h
#define vtkSpherePackingFieldBox_h

#include "metaballs/FieldScene.h"

#include "vtkABINamespace.h"

VTK_ABI_NAMESPACE_BEGIN
class vtkSpherePackingFieldInput;

// Sets a box on whose sides the field is below `threshold`, as seen at `places` x `places` points
// of each. Of kernels that end, or nearly so, a box outside which nothing reaches the threshold.
// False if there is nothing to enclose.
bool vtkSpherePackingEncloseSurface(const vtkSpherePackingFieldInput& input,
  spherepacking::BlobKind kind, double threshold, int places, double (&box)[6]);

// The origin and the power of two that make a box about 1 long.
void vtkSpherePackingScaleOf(const double (&box)[6], double (&origin)[3], double& scale);
VTK_ABI_NAMESPACE_END

#endif
