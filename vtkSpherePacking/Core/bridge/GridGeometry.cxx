// SPDX-License-Identifier: BSD-3-Clause
#include "bridge/GridGeometry.h"

#include "bridge/CoordinateRange.h"
#include "bridge/EncloseSurface.h"
#include "bridge/Guard.h"
#include "bridge/MemoryLimit.h"
#include "bridge/PackingCharges.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace spherepacking
{
namespace
{
// The bounds of the spheres with a margin of a tenth of their longest side.
void AddMargin(const PackingCharges& charges, double (&bounds)[6])
{
  double length = 0.0;
  for (int axis = 0; axis < 3; ++axis)
  {
    length = std::max(length, charges.Bounds[2 * axis + 1] - charges.Bounds[2 * axis]);
  }
  for (int side = 0; side < 6; ++side)
  {
    const double margin = 0.1 * (length > 0.0 ? length : 1.0);
    bounds[side] = charges.Bounds[side] + (side % 2 ? margin : -margin);
  }
}

void FindBounds(const GridRequest& request, const PackingCharges& charges, double (&bounds)[6])
{
  const int largest = *std::max_element(request.Dimensions, request.Dimensions + 3);
  if (request.HasBounds())
  {
    std::copy_n(request.ModelBounds, 6, bounds);
  }
  else if (!charges.Empty() &&
    !(request.Threshold > 0.0 &&
      EncloseSurface(charges, request.Kind, request.Threshold, std::min(largest, 512), bounds)))
  {
    AddMargin(charges, bounds);
  }
  try
  {
    CheckCoordinateRange(bounds);
  }
  catch (const std::invalid_argument&)
  {
    if (request.HasBounds())
    {
      Refuse("bounds", Join(bounds, 6), "coordinates up to 1e30");
    }
    Refuse("threshold",
      Join(&request.Threshold, 1) + ", whose surface lies beyond coordinates of 1e30",
      "a larger one");
  }
}

void CheckSize(const GridRequest& request, const GridGeometry& grid)
{
  // A vtkImageData stores the coordinates along each axis, 8 bytes each; up to three images exist
  // at the same time.
  const double axes =
    24.0 * (static_cast<double>(grid.Dimensions[0]) + grid.Dimensions[1] + grid.Dimensions[2]);
  if (grid.Points() * request.BytesPerPoint + axes > HalfOfMemory())
  {
    const bool spaced = request.HasSpacing();
    Refuse(spaced ? "spacing" : "dimensions",
      (spaced ? Join(request.Spacing, 3) : Join(request.Dimensions, 3)) + ", which makes " +
        Join(grid.Dimensions, 3) + " points, more than fit in half of the memory",
      "fewer");
  }
}
}

//------------------------------------------------------------------------------
void CheckGridRequest(const GridRequest& request)
{
  if (std::any_of(request.Dimensions, request.Dimensions + 3, [](int n) { return n < 1; }))
  {
    Refuse("dimensions", Join(request.Dimensions, 3), "three numbers from 1 on");
  }
  const double* spacing = request.Spacing;
  const bool given = spacing[0] != 0.0 || spacing[1] != 0.0 || spacing[2] != 0.0;
  if (given &&
    !std::all_of(
      spacing, spacing + 3, [](double step) { return step > 0.0 && std::isfinite(step); }))
  {
    Refuse("spacing", Join(spacing, 3), "three numbers above 0");
  }
  const double* bounds = request.ModelBounds;
  for (int axis = 0; axis < 3 && request.HasBounds(); ++axis)
  {
    if (!std::isfinite(bounds[2 * axis + 1] - bounds[2 * axis]) ||
      bounds[2 * axis] > bounds[2 * axis + 1])
    {
      Refuse("bounds", Join(bounds, 6), "x min, x max, y min, y max, z min and z max");
    }
  }
  if (!(request.Threshold >= 0.0 && std::isfinite(request.Threshold)))
  {
    Refuse("threshold", request.Threshold, "a number above 0");
  }
}

//------------------------------------------------------------------------------
GridGeometry ResolveGrid(const GridRequest& request, const PackingCharges& charges)
{
  double bounds[6] = { -0.5, 0.5, -0.5, 0.5, -0.5, 0.5 };
  FindBounds(request, charges, bounds);
  GridGeometry grid;
  for (int axis = 0; axis < 3; ++axis)
  {
    const double length = bounds[2 * axis + 1] - bounds[2 * axis];
    grid.Origin[axis] = bounds[2 * axis];
    grid.Dimensions[axis] = request.Dimensions[axis];
    grid.Spacing[axis] = grid.Dimensions[axis] > 1 ? length / (grid.Dimensions[axis] - 1) : 0.0;
    if (request.HasSpacing())
    {
      // Rounding makes no further point.
      const double steps = std::ceil(length / request.Spacing[axis] * (1.0 - 1e-12));
      grid.Spacing[axis] = request.Spacing[axis];
      grid.Dimensions[axis] = static_cast<int>(std::min(steps, 1e9)) + 1;
    }
    else if (grid.Dimensions[axis] == 1)
    {
      // A single point lies in the middle.
      grid.Spacing[axis] = 1.0;
      grid.Origin[axis] += 0.5 * length;
    }
    else if (!(grid.Spacing[axis] > 0.0))
    {
      Refuse("bounds", Join(bounds, 6), "a length above 0 along axes with more than one point");
    }
  }
  CheckSize(request, grid);
  return grid;
}
}
