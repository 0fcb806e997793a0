// SPDX-License-Identifier: BSD-3-Clause
// In which order to draw the blocks of a packing. Private to the module.
#ifndef vtkSpherePackingPhases_h
#define vtkSpherePackingPhases_h

#include "vtkABINamespace.h"
#include "vtkSpherePackingVertices.h"
#include "vtkSpherePackingView.h"

#include <vector>

VTK_ABI_NAMESPACE_BEGIN
// Runs of vertices, as glMultiDrawArrays() takes them.
struct vtkSpherePackingRuns
{
  std::vector<int> Firsts;
  std::vector<int> Counts;

  void Add(vtkIdType begin, vtkIdType end);
};

// All vertices at once.
std::vector<vtkSpherePackingRuns> vtkSpherePackingMakeOnePhase(
  const vtkSpherePackingVertices& vertices);

// The blocks in the view volume in a few phases: first what is nearest to the eye in each part of
// the window, so that it can hide what comes after. One phase for a packing that is too small for
// that to pay.
std::vector<vtkSpherePackingRuns> vtkSpherePackingMakePhases(
  const vtkSpherePackingVertices& vertices, const vtkSpherePackingView& view);
VTK_ABI_NAMESPACE_END

#endif
