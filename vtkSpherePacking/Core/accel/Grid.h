// SPDX-License-Identifier: BSD-3-Clause
/// A uniform grid of cells over a box, and which of them a sphere touches.
#ifndef Grid_h
#define Grid_h

#include "accel/SphereBox.h"

#include <algorithm>
#include <cmath>
#include <cstdint>

namespace spherepacking
{
struct Grid
{
  Box Bounds;
  std::int64_t Cells; ///< along each axis

  std::int64_t Count() const { return this->Cells * this->Cells * this->Cells; }

  /// x runs fastest. Neighbours share the same plane to the last bit, and the outer planes are
  /// those of the box.
  Box CellAt(std::int64_t index) const
  {
    Box cell;
    for (int axis = 0; axis < 3; ++axis, index /= this->Cells)
    {
      cell.Low[axis] = this->Plane(axis, index % this->Cells);
      cell.High[axis] = this->Plane(axis, index % this->Cells + 1);
    }
    return cell;
  }

  /// Calls `visit` with the index of every cell that the sphere touches.
  template <typename Visit>
  void ForEachTouched(const Sphere& sphere, Visit&& visit) const
  {
    std::int64_t first[3];
    std::int64_t last[3];
    const double center[3] = { sphere.X, sphere.Y, sphere.Z };
    for (int axis = 0; axis < 3; ++axis)
    {
      first[axis] = this->Candidate(axis, center[axis] - sphere.R, -1.0);
      last[axis] = this->Candidate(axis, center[axis] + sphere.R, 1.0);
    }
    for (std::int64_t z = first[2]; z <= last[2]; ++z)
    {
      for (std::int64_t y = first[1]; y <= last[1]; ++y)
      {
        for (std::int64_t x = first[0]; x <= last[0]; ++x)
        {
          const std::int64_t index = (z * this->Cells + y) * this->Cells + x;
          if (Touches(sphere, this->CellAt(index)))
          {
            visit(index);
          }
        }
      }
    }
  }

  /// The cell of a coordinate, the nearest one outside the box.
  std::int64_t CellOf(int axis, double x) const
  {
    const double low = this->Bounds.Low[axis];
    const double extent = this->Bounds.High[axis] - low;
    if (!(extent > 0.0))
    {
      return 0;
    }
    const double cell = std::floor((x - low) / extent * static_cast<double>(this->Cells));
    return static_cast<std::int64_t>(std::clamp(cell, 0.0, static_cast<double>(this->Cells - 1)));
  }

  double Plane(int axis, std::int64_t i) const
  {
    const double fraction = static_cast<double>(i) / static_cast<double>(this->Cells);
    return i == this->Cells
      ? this->Bounds.High[axis]
      : this->Bounds.Low[axis] + fraction * (this->Bounds.High[axis] - this->Bounds.Low[axis]);
  }

private:
  // The cell of a coordinate, or the one beside it when rounding may decide between them. The exact
  // test comes after; this one may be wrong on the safe side only. A few rounding errors of the
  // coordinates, in cells, are the margin.
  std::int64_t Candidate(int axis, double x, double side) const
  {
    const double low = this->Bounds.Low[axis];
    const double high = this->Bounds.High[axis];
    const double size = (high - low) / static_cast<double>(this->Cells);
    if (!(size > 0.0))
    {
      return side < 0.0 ? 0 : this->Cells - 1;
    }
    const double margin = 1e-9 + 1e-15 * std::max(std::abs(low), std::abs(high)) / size;
    const double cell = std::floor((x - low) / size + side * margin);
    return static_cast<std::int64_t>(std::clamp(cell, 0.0, static_cast<double>(this->Cells - 1)));
  }
};
}

#endif
