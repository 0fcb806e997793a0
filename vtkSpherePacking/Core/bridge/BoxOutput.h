// SPDX-License-Identifier: BSD-3-Clause
/// Boxes as a vtkPolyData, with cell arrays of one value per box.
#ifndef BoxOutput_h
#define BoxOutput_h

#include "accel/SphereBox.h"

#include "vtkType.h"

#include <string>
#include <vector>

class vtkPolyData;

namespace spherepacking
{
struct BoxOutput
{
  std::vector<Box> Boxes;
  std::vector<vtkIdType> Ids;    ///< cell array `box_id`
  std::vector<int> Depths;       ///< cell array `depth`
  std::vector<vtkIdType> Counts; ///< cell array `count`

  /// Points, cells and arrays of a box in the output, and before that in the lists above.
  static constexpr double BytesPerBox = 768.0;

  /// Makes room. More boxes than fit in half of the memory throw a std::invalid_argument, which
  /// begins with what was asked for.
  void Reserve(const std::string& asked, vtkIdType count);

  void Add(const Box& box, vtkIdType id, int depth, vtkIdType count);

  /// Eight points per box, and six quads whose normals point outwards, or twelve lines. No two
  /// boxes share points, so that they can be coloured, shrunk and shaded one by one.
  void Write(vtkPolyData* output, bool asLines) const;
};
}

#endif
