// SPDX-License-Identifier: BSD-3-Clause
// Boxes as a vtkPolyData, with cell arrays of one value a box. Private to the module.
#ifndef vtkSpherePackingBoxes_h
#define vtkSpherePackingBoxes_h

#include "kernels/SphereBox.h"

#include "vtkABINamespace.h"
#include "vtkType.h"

#include <string>
#include <vector>

VTK_ABI_NAMESPACE_BEGIN
class vtkPolyData;

struct vtkSpherePackingBoxes
{
  std::vector<spherepacking::Box> Boxes;
  std::vector<vtkIdType> Ids;    // cell array `box_id`
  std::vector<int> Depths;       // cell array `depth`
  std::vector<vtkIdType> Counts; // cell array `count`

  // Points, cells and arrays of a box in the output, and before that in the lists above.
  static constexpr double BytesPerBox = 768.0;

  // Makes room. More boxes than fit in half of the memory throw a std::invalid_argument, which
  // begins with what was asked for.
  void Reserve(const std::string& asked, vtkIdType count);

  void Add(const spherepacking::Box& box, vtkIdType id, int depth, vtkIdType count);

  // Eight points a box, and six quads whose normals point outwards, or twelve lines. No two boxes
  // share points, so that they can be coloured, shrunk and shaded one by one.
  void Write(vtkPolyData* output, bool asLines) const;
};
VTK_ABI_NAMESPACE_END

#endif
