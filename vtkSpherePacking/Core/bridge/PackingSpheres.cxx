// SPDX-License-Identifier: BSD-3-Clause
#include "bridge/PackingSpheres.h"

#include "vtkDataArray.h"
#include "vtkDataArrayRange.h"
#include "vtkDoubleArray.h"
#include "vtkFloatArray.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"

#include <algorithm>
#include <cstdint>

namespace spherepacking
{
namespace
{
// Points one of the pointers at the values, of which `copy` is one if they are of another type.
void Use(
  vtkDataArray* array, const float*& floats, const double*& doubles, std::vector<double>& copy)
{
  if (auto* floatArray = vtkFloatArray::FastDownCast(array))
  {
    floats = floatArray->GetPointer(0);
  }
  else if (auto* doubleArray = vtkDoubleArray::FastDownCast(array))
  {
    doubles = doubleArray->GetPointer(0);
  }
  else
  {
    const auto values = vtk::DataArrayValueRange(array);
    copy.assign(values.begin(), values.end());
    doubles = copy.data();
  }
}

template <typename T>
void Copy(
  const T*& values, std::int64_t count, HugeArray<char>& copy, const ParallelFor& parallelFor)
{
  if (!values)
  {
    return;
  }
  constexpr std::int64_t part = 1 << 16;
  copy = HugeArray<char>(static_cast<std::size_t>(count) * sizeof(T));
  T* const to = reinterpret_cast<T*>(copy.data());
  parallelFor((count + part - 1) / part, [&](std::int64_t i)
    { std::copy(values + i * part, values + std::min((i + 1) * part, count), to + i * part); });
  values = to;
}
}

//------------------------------------------------------------------------------
PackingSpheres::PackingSpheres(vtkPolyData* packing, vtkDataArray* radii)
{
  if (radii && radii->GetNumberOfTuples() > 0)
  {
    this->Spheres.Count = radii->GetNumberOfTuples();
    Use(packing->GetPoints()->GetData(), this->Spheres.FloatCenters, this->Spheres.DoubleCenters,
      this->Centers);
    Use(radii, this->Spheres.FloatRadii, this->Spheres.DoubleRadii, this->Radii);
  }
}

//------------------------------------------------------------------------------
void PackingSpheres::Own(const ParallelFor& parallelFor)
{
  SphereArrays& spheres = this->Spheres;
  if (this->Centers.empty())
  {
    Copy(spheres.FloatCenters, 3 * spheres.Count, this->OwnCenters, parallelFor);
    Copy(spheres.DoubleCenters, 3 * spheres.Count, this->OwnCenters, parallelFor);
  }
  if (this->Radii.empty())
  {
    Copy(spheres.FloatRadii, spheres.Count, this->OwnRadii, parallelFor);
    Copy(spheres.DoubleRadii, spheres.Count, this->OwnRadii, parallelFor);
  }
}
}
