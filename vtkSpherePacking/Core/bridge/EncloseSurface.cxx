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
// Faces of boxes around the charges. On a plane outside the bounds of the charges' centres a field
// that decreases with the distance is largest within the projection of these bounds, so this is
// where it is sampled.
class BoxFace
{
public:
  BoxFace(FieldScene& scene, const double (&centers)[6], int axis, bool upper)
    : Scene(scene)
    , Centers(centers)
    , Axis(axis)
    , Upper(upper)
  {
  }

  // The distance of a face from the bounds at which the field falls below the threshold, to a
  // twentieth, by bisection from `lowest` on.
  double Margin(double lowest, double threshold, int samples)
  {
    constexpr int few = 24;
    double low = lowest;
    double high = lowest;
    while (this->MaxValue(high, few) >= threshold)
    {
      low = high;
      high = 2.0 * high + 1e-3;
    }
    while (high - low > 0.05 * high)
    {
      const double middle = 0.5 * (low + high);
      (this->MaxValue(middle, few) >= threshold ? low : high) = middle;
    }
    while (samples > few && this->MaxValue(high, samples) >= threshold)
    {
      high = 1.05 * high + 1e-3;
    }
    return high;
  }

private:
  // Bound for the field at the samples of a face.
  double MaxValue(double margin, int samples)
  {
    FieldGrid& grid = this->Scene.Grid;
    std::int64_t count = 1;
    for (int axis = 0; axis < 3; ++axis)
    {
      const double low = this->Centers[2 * axis];
      const double high = this->Centers[2 * axis + 1];
      const bool flat = axis == this->Axis || !(high > low);
      grid.Dimensions[axis] = flat ? 1 : samples;
      grid.Origin[axis] = axis != this->Axis ? low : this->Upper ? high + margin : low - margin;
      grid.Spacing[axis] = flat ? 1.0 : (high - low) / (samples - 1);
      count *= grid.Dimensions[axis];
    }
    std::vector<float> values(static_cast<std::size_t>(count));
    grid.Field = values.data();
    const std::vector<FieldBlock> blocks = CutIntoBlocks(this->Scene);
    SmpParallelFor()(static_cast<std::int64_t>(blocks.size()),
      [&](std::int64_t i) { SumField(this->Scene, blocks[i]); });
    grid.Field = nullptr;
    const double error = this->Scene.Expansions ? this->Scene.Expansions->TruncationError : 0.0;
    return *std::max_element(values.begin(), values.end()) * (1.0 + error);
  }

  FieldScene& Scene;
  const double (&Centers)[6];
  const int Axis;
  const bool Upper;
};

// The distance in radii at which a sphere adds `part` of its weight; for Wyvill where it ends.
double ReachOf(BlobKind kind, double part)
{
  switch (kind)
  {
    case BlobKind::Gaussian:
      return std::sqrt(std::max(0.0, 1.0 - 0.5 * std::log(part)));
    case BlobKind::Wyvill:
      return 2.0;
    case BlobKind::InverseSquare:
      return std::sqrt(1.0 / part);
    default:
      return 1.0 / part;
  }
}

// Widens a box so that outside of it no sphere adds more than the threshold divided by `number`.
void EncloseReach(const std::vector<Charge>& spheres, BlobKind kind, double threshold,
  double number, double (&box)[6])
{
  for (const Charge& sphere : spheres)
  {
    const double part = threshold / (number * sphere.Strength);
    const double reach = sphere.Strength > 0.0f ? ReachOf(kind, part) * sphere.Radius : 0.0;
    for (int axis = 0; axis < 3; ++axis)
    {
      box[2 * axis] = std::min(box[2 * axis], sphere.Position[axis] - reach);
      box[2 * axis + 1] = std::max(box[2 * axis + 1], sphere.Position[axis] + reach);
    }
  }
}
}

//------------------------------------------------------------------------------
void FindUnitScale(const double (&box)[6], double (&origin)[3], double& scale)
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
  const PackingCharges& charges, BlobKind kind, double threshold, int samples, double (&box)[6])
{
  double origin[3];
  double scale;
  FindUnitScale(charges.Bounds, origin, scale);
  std::vector<Charge> spheres = charges.Scaled(origin, scale);
  // The strengths are weights over the largest one.
  threshold /= charges.MaxWeight > 0.0 ? charges.MaxWeight : 1.0;
  double centers[6];
  double enclosed[6];
  for (int side = 0; side < 6; ++side)
  {
    centers[side] = (charges.CenterBounds[side] - origin[side / 2]) * scale;
    enclosed[side] = centers[side];
  }
  const bool decays = kind == BlobKind::Gaussian || kind == BlobKind::Wyvill;
  const double number = decays ? static_cast<double>(spheres.size()) : 1.0;
  EncloseReach(spheres, kind, threshold, number, enclosed);
  if (!decays)
  {
    FieldScene scene = PrepareField(kind, std::move(spheres), 1e-2, SmpParallelFor());
    for (int side = 0; side < 6; ++side)
    {
      const double sign = side % 2 ? 1.0 : -1.0;
      const double lowest = sign * (enclosed[side] - centers[side]);
      enclosed[side] = centers[side] +
        sign * BoxFace(scene, centers, side / 2, side % 2).Margin(lowest, threshold, samples);
    }
  }
  double length = 0.0;
  for (int axis = 0; axis < 3; ++axis)
  {
    length = std::max(length, enclosed[2 * axis + 1] - enclosed[2 * axis]);
  }
  if (!(length > 0.0))
  {
    return false;
  }
  for (int side = 0; side < 6; ++side)
  {
    // A margin, so that the surface does not touch the faces.
    const double margin = side % 2 ? 0.02 : -0.02;
    box[side] = origin[side / 2] + (enclosed[side] + margin * length) / scale;
  }
  return true;
}
}
