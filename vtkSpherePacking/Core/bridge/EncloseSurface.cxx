// SPDX-License-Identifier: BSD-3-Clause
#include "bridge/EncloseSurface.h"

#include "bridge/PackingCharges.h"
#include "bridge/SmpParallelFor.h"

#include <algorithm>
#include <cmath>

namespace spherepacking
{
namespace
{
// The largest value on a plane outside all centres. There the field falls with the distance from
// them along the plane's normal, and is largest over the centres' box, which is where it is
// sampled.
class Side
{
public:
  Side(FieldScene& scene, const double (&centers)[6], int axis, bool upper)
    : Scene(scene)
    , Centers(centers)
    , Axis(axis)
    , Upper(upper)
  {
  }

  double Most(double margin, int places)
  {
    FieldGrid& grid = this->Scene.Grid;
    std::int64_t count = 1;
    for (int axis = 0; axis < 3; ++axis)
    {
      const double low = this->Centers[2 * axis];
      const double high = this->Centers[2 * axis + 1];
      const bool flat = axis == this->Axis || !(high > low);
      grid.Dimensions[axis] = flat ? 1 : places;
      grid.Origin[axis] = axis != this->Axis ? low : this->Upper ? high + margin : low - margin;
      grid.Spacing[axis] = flat ? 1.0 : (high - low) / (places - 1);
      count *= grid.Dimensions[axis];
    }
    std::vector<float> values(static_cast<std::size_t>(count));
    grid.Field = values.data();
    const std::vector<FieldBlock> blocks = CutIntoBlocks(this->Scene);
    SmpParallelFor()(static_cast<std::int64_t>(blocks.size()),
      [&](std::int64_t i) { SumField(this->Scene, blocks[i]); });
    grid.Field = nullptr;
    return *std::max_element(values.begin(), values.end()) * (1.0 + this->Scene.Error);
  }

  // The margin, to a twentieth, at which the largest value is below the threshold.
  double Margin(double least, double threshold, int places)
  {
    constexpr int few = 24;
    double low = least;
    double high = least;
    while (this->Most(high, few) >= threshold)
    {
      low = high;
      high = 2.0 * high + 1e-3;
    }
    while (high - low > 0.05 * high)
    {
      const double middle = 0.5 * (low + high);
      (this->Most(middle, few) >= threshold ? low : high) = middle;
    }
    while (places > few && this->Most(high, places) >= threshold)
    {
      high = 1.05 * high + 1e-3;
    }
    return high;
  }

private:
  FieldScene& Scene;
  const double (&Centers)[6];
  const int Axis;
  const bool Upper;
};

// How far what one sphere adds is above its part of the threshold.
double ReachOf(BlobKind kind, double share)
{
  switch (kind)
  {
    case BlobKind::Gaussian:
      return std::sqrt(std::max(0.0, 1.0 - 0.5 * std::log(share)));
    case BlobKind::Wyvill:
      return 2.0;
    case BlobKind::InverseSquare:
      return std::sqrt(1.0 / share);
    default:
      return 1.0 / share;
  }
}
}

//------------------------------------------------------------------------------
void ScaleOf(const double (&box)[6], double (&origin)[3], double& scale)
{
  double length = 0.0;
  for (int axis = 0; axis < 3; ++axis)
  {
    origin[axis] = 0.5 * (box[2 * axis] + box[2 * axis + 1]);
    length = std::max(length, box[2 * axis + 1] - box[2 * axis]);
  }
  int exponent = 0;
  std::frexp(length, &exponent);
  scale = length > 0.0 ? std::ldexp(1.0, -exponent) : 1.0;
}

//------------------------------------------------------------------------------
bool EncloseSurface(
  const FieldInput& input, BlobKind kind, double threshold, int places, double (&box)[6])
{
  double origin[3];
  double scale;
  ScaleOf(input.Bounds, origin, scale);
  std::vector<Charge> spheres = input.Scaled(origin, scale);
  const bool ends = kind == BlobKind::Gaussian || kind == BlobKind::Wyvill;
  threshold /= input.MostWeight > 0.0 ? input.MostWeight : 1.0;
  const double number = ends ? static_cast<double>(spheres.size()) : 1.0;
  double centers[6];
  double reached[6];
  for (int side = 0; side < 6; ++side)
  {
    centers[side] = (input.Centers[side] - origin[side / 2]) * scale;
    reached[side] = centers[side];
  }
  for (const Charge& sphere : spheres)
  {
    const double share = threshold / (number * sphere.Strength);
    const double reach = sphere.Strength > 0.0f ? ReachOf(kind, share) * sphere.Radius : 0.0;
    for (int axis = 0; axis < 3; ++axis)
    {
      reached[2 * axis] = std::min(reached[2 * axis], sphere.X[axis] - reach);
      reached[2 * axis + 1] = std::max(reached[2 * axis + 1], sphere.X[axis] + reach);
    }
  }
  if (!ends)
  {
    FieldScene scene = PrepareField(kind, std::move(spheres), 1e-2, SmpParallelFor());
    for (int side = 0; side < 6; ++side)
    {
      const double out = side % 2 ? 1.0 : -1.0;
      const double least = out * (reached[side] - centers[side]);
      reached[side] = centers[side] +
        out * Side(scene, centers, side / 2, side % 2).Margin(least, threshold, places);
    }
  }
  double length = 0.0;
  for (int axis = 0; axis < 3; ++axis)
  {
    length = std::max(length, reached[2 * axis + 1] - reached[2 * axis]);
  }
  if (!(length > 0.0))
  {
    return false;
  }
  for (int side = 0; side < 6; ++side)
  {
    // Some room, so that the surface does not touch the sides.
    const double out = side % 2 ? 0.02 : -0.02;
    box[side] = origin[side / 2] + (reached[side] + out * length) / scale;
  }
  return true;
}
}
