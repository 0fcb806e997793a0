// SPDX-License-Identifier: BSD-3-Clause
#include "bridge/PackingCharges.h"

#include "bridge/PackingSpheres.h"

#include "vtkDataArray.h"
#include "vtkPolyData.h"

#include <algorithm>
#include <numeric>

namespace spherepacking
{
//------------------------------------------------------------------------------
FieldInput::FieldInput(
  vtkPolyData* packing, vtkDataArray* radii, vtkIdType count, const std::vector<double>& weights)
  : Packing(packing)
  , Radii(radii)
  , Weights(weights)
{
  const PackingSpheres arrays(packing, radii);
  const SphereArrays& spheres = arrays.Get();
  this->Number = spheres.Count;
  if (this->Weights.empty())
  {
    this->Weights.push_back(1.0);
  }
  this->MostWeight = *std::max_element(this->Weights.begin(), this->Weights.end());
  if ((count > 0 && count < this->Number) || this->Weights.size() > 1)
  {
    this->Ranks.resize(this->Number);
    std::iota(this->Ranks.begin(), this->Ranks.end(), 0);
    std::sort(this->Ranks.begin(), this->Ranks.end(),
      [&](std::int32_t one, std::int32_t other)
      {
        const double both[2] = { spheres[one].R, spheres[other].R };
        return both[0] != both[1] ? both[0] > both[1] : one < other;
      });
    if (count > 0 && count < this->Number)
    {
      this->Number = count;
      this->Ranks.resize(count);
    }
  }
  for (int side = 0; side < 6; ++side)
  {
    this->Centers[side] = this->Bounds[side] = 0.0;
  }
  for (vtkIdType rank = 0; rank < this->Number; ++rank)
  {
    const Sphere sphere = spheres[this->Ranks.empty() ? rank : this->Ranks[rank]];
    const double center[3] = { sphere.X, sphere.Y, sphere.Z };
    for (int axis = 0; axis < 3; ++axis)
    {
      const auto widen = [&](double (&box)[6], double radius)
      {
        double& low = box[2 * axis];
        double& high = box[2 * axis + 1];
        low = rank == 0 ? center[axis] - radius : std::min(low, center[axis] - radius);
        high = rank == 0 ? center[axis] + radius : std::max(high, center[axis] + radius);
      };
      widen(this->Centers, 0.0);
      widen(this->Bounds, sphere.R);
    }
  }
}

//------------------------------------------------------------------------------
double FieldInput::WeightOf(vtkIdType rank) const
{
  const auto number = static_cast<vtkIdType>(this->Weights.size());
  return this->Weights[rank * number / this->Number];
}

//------------------------------------------------------------------------------
std::vector<Charge> FieldInput::Scaled(const double (&origin)[3], double scale) const
{
  const PackingSpheres arrays(this->Packing, this->Radii);
  const SphereArrays& spheres = arrays.Get();
  std::vector<Charge> charges;
  charges.reserve(this->Number);
  const double unit = this->MostWeight > 0.0 ? this->MostWeight : 1.0;
  for (vtkIdType rank = 0; rank < this->Number; ++rank)
  {
    const vtkIdType id = this->Ranks.empty() ? rank : this->Ranks[rank];
    const Sphere sphere = spheres[id];
    charges.push_back({ { (sphere.X - origin[0]) * scale, (sphere.Y - origin[1]) * scale,
                          (sphere.Z - origin[2]) * scale },
      static_cast<float>(this->WeightOf(rank) / unit), static_cast<float>(sphere.R * scale),
      static_cast<std::int32_t>(id) });
  }
  return charges;
}
}
