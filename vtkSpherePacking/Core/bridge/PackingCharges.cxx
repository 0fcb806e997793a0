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
PackingCharges::PackingCharges(
  vtkPolyData* packing, vtkDataArray* radii, vtkIdType count, const std::vector<double>& weights)
  : Packing(packing)
  , Radii(radii)
  , Weights(weights)
{
  const PackingSpheres arrays(packing, radii);
  const SphereArrays& spheres = arrays.Get();
  if (this->Weights.empty())
  {
    this->Weights.push_back(1.0);
  }
  this->MaxWeight = *std::max_element(this->Weights.begin(), this->Weights.end());
  this->Number = spheres.Count;
  const bool limited = count > 0 && count < this->Number;
  if (limited || this->Weights.size() > 1)
  {
    this->RankByRadius(spheres);
  }
  if (limited)
  {
    this->Number = count;
    this->IdOfRank.resize(count);
  }
  this->FindBounds(spheres);
}

//------------------------------------------------------------------------------
void PackingCharges::RankByRadius(const SphereArrays& spheres)
{
  this->IdOfRank.resize(spheres.Count);
  std::iota(this->IdOfRank.begin(), this->IdOfRank.end(), 0);
  std::sort(this->IdOfRank.begin(), this->IdOfRank.end(),
    [&](std::int32_t one, std::int32_t other)
    {
      const double radii[2] = { spheres[one].R, spheres[other].R };
      return radii[0] != radii[1] ? radii[0] > radii[1] : one < other;
    });
}

//------------------------------------------------------------------------------
void PackingCharges::FindBounds(const SphereArrays& spheres)
{
  std::fill_n(this->CenterBounds, 6, 0.0);
  std::fill_n(this->Bounds, 6, 0.0);
  for (vtkIdType rank = 0; rank < this->Number; ++rank)
  {
    const Sphere sphere = spheres[this->IdAt(rank)];
    const double center[3] = { sphere.X, sphere.Y, sphere.Z };
    for (int axis = 0; axis < 3; ++axis)
    {
      const auto widen = [&](double (&bounds)[6], double radius)
      {
        double& low = bounds[2 * axis];
        double& high = bounds[2 * axis + 1];
        low = rank == 0 ? center[axis] - radius : std::min(low, center[axis] - radius);
        high = rank == 0 ? center[axis] + radius : std::max(high, center[axis] + radius);
      };
      widen(this->CenterBounds, 0.0);
      widen(this->Bounds, sphere.R);
    }
  }
}

//------------------------------------------------------------------------------
double PackingCharges::WeightOf(vtkIdType rank) const
{
  const auto number = static_cast<vtkIdType>(this->Weights.size());
  return this->Weights[rank * number / this->Number];
}

//------------------------------------------------------------------------------
std::vector<Charge> PackingCharges::Scaled(const double (&origin)[3], double scale) const
{
  const PackingSpheres arrays(this->Packing, this->Radii);
  const SphereArrays& spheres = arrays.Get();
  std::vector<Charge> charges;
  charges.reserve(this->Number);
  const double unit = this->MaxWeight > 0.0 ? this->MaxWeight : 1.0;
  for (vtkIdType rank = 0; rank < this->Number; ++rank)
  {
    const vtkIdType id = this->IdAt(rank);
    const Sphere sphere = spheres[id];
    charges.push_back({ { (sphere.X - origin[0]) * scale, (sphere.Y - origin[1]) * scale,
                          (sphere.Z - origin[2]) * scale },
      static_cast<float>(this->WeightOf(rank) / unit), static_cast<float>(sphere.R * scale),
      static_cast<std::int32_t>(id) });
  }
  return charges;
}
}
