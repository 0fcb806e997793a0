// SPDX-License-Identifier: BSD-3-Clause
/// Traversal of a uniform grid by a single ray.
#ifndef TraceGrid_h
#define TraceGrid_h

#include "accel/GridTable.h"
#include "trace/RayBlock.h"

namespace spherepacking
{
inline namespace SPHEREPACKING_ISA
{
/// Walks through the cells along a ray (3D-DDA).
///
/// Source: Amanatides and Woo, "A Fast Voxel Traversal Algorithm for Ray Tracing" (1987). Where a
/// ray leaves a cell is computed from the cell's planes, not summed up, so that errors do not add
/// up. A ray along a plane between cells stays on one side, which is as good as the other, since
/// cells list what touches them from outside.
class CellWalk
{
public:
  CellWalk(const Grid& grid, const Ray& ray)
    : Cells(grid)
    , Line(ray)
  {
    double enter = 0.0;
    double leave = NoHit;
    for (int axis = 0; axis < 3; ++axis)
    {
      const double low = grid.Bounds.Low[axis];
      const double high = grid.Bounds.High[axis];
      if (ray.D[axis] == 0.0)
      {
        this->Inside &= low <= ray.O[axis] && ray.O[axis] <= high;
        continue;
      }
      this->Inverse[axis] = 1.0 / ray.D[axis];
      const double a = (low - ray.O[axis]) * this->Inverse[axis];
      const double b = (high - ray.O[axis]) * this->Inverse[axis];
      enter = std::max(enter, std::min(a, b));
      leave = std::min(leave, std::max(a, b));
    }
    // A few rounding errors: what is at the border of the scene may be hit.
    this->Inside &= enter <= leave * (1.0 + 1e-14);
    for (int axis = 0; axis < 3; ++axis)
    {
      this->At[axis] = grid.CellOf(axis, ray.O[axis] + enter * ray.D[axis]);
      this->SetLeave(axis);
    }
  }

  /// Whether there is a cell.
  bool Valid() const { return this->Inside; }

  std::int64_t Cell() const
  {
    return (this->At[2] * this->Cells.Cells + this->At[1]) * this->Cells.Cells + this->At[0];
  }

  /// Where the ray leaves the cell.
  double Leave() const
  {
    return std::min(std::min(this->LeaveT[0], this->LeaveT[1]), this->LeaveT[2]);
  }

  void Next()
  {
    int axis = this->LeaveT[1] < this->LeaveT[0] ? 1 : 0;
    axis = this->LeaveT[2] < this->LeaveT[axis] ? 2 : axis;
    this->At[axis] += this->Line.D[axis] > 0.0 ? 1 : -1;
    this->Inside = this->At[axis] >= 0 && this->At[axis] < this->Cells.Cells;
    if (this->Inside)
    {
      this->SetLeave(axis);
    }
  }

private:
  void SetLeave(int axis)
  {
    const double direction = this->Line.D[axis];
    this->LeaveT[axis] = direction == 0.0
      ? NoHit
      : (this->Cells.Plane(axis, this->At[axis] + (direction > 0.0)) - this->Line.O[axis]) *
        this->Inverse[axis];
  }

  const Grid& Cells;
  const Ray& Line;
  bool Inside = true;
  double Inverse[3] = {};
  double LeaveT[3];
  std::int64_t At[3];
};

template <typename RayT>
inline Hit FirstHit(
  const GridTable& table, const SphereArrays& spheres, const Ray& ray, const RayT& kind)
{
  const double inverseSquare = InverseSquare(ray);
  Hit hit;
  for (CellWalk walk(table.Cells, ray); walk.Valid(); walk.Next())
  {
    const std::int64_t cell = walk.Cell();
    for (std::int64_t i = table.Starts[cell]; i < table.Starts[cell + 1]; ++i)
    {
      const std::int32_t id = table.Ids[i];
      const Sphere sphere = spheres[id];
      hit.Offer(kind.Hit(ray, sphere, inverseSquare, id), id, sphere);
    }
    if (hit.T <= walk.Leave() || (RayT::AnyHit && hit.Id >= 0))
    {
      break;
    }
  }
  return hit;
}
}
}

#endif
