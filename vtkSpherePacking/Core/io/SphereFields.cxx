// SPDX-License-Identifier: BSD-3-Clause
#include "io/SphereFields.h"

#include "io/Number.h"
#include "io/PackingFileError.h"

#include "vtkIntArray.h"

#include <cmath>
#include <limits>

namespace spherepacking
{
namespace
{
template <typename Real>
Real ParseValue(const SphereFields& sphere, int which, SphereSize size)
{
  const std::string_view field = sphere.Numbers[which];
  const char* const end = field.data() + field.size();
  Real value{};
  const char* expected = nullptr;
  if (ParseNumber(field.data(), end, value) != end)
  {
    expected = "a number";
  }
  else if (!(std::abs(value) <= std::numeric_limits<Real>::max()))
  {
    expected = "a finite number";
  }
  else if (which == 3 && IsNegative(field.data(), end, value))
  {
    expected = "a number that is not negative";
  }
  if (expected)
  {
    const char* const names[] = { "x", "y", "z",
      size == SphereSize::Radius ? "radius" : "diameter" };
    throw LineError(sphere.Line,
      "found " + Quote(field.data(), end) + " as " + names[which] + ", expected " + expected);
  }
  return value;
}

template <typename Real>
void Fill(PackingArrays& arrays, const std::vector<SphereFields>& spheres, SphereSize size,
  Progress& progress)
{
  Real* center = arrays.Centers<Real>();
  Real* radius = arrays.Radii<Real>();
  constexpr std::size_t batch = 1 << 16;
  for (std::size_t i = 0; i < spheres.size(); ++i)
  {
    for (int axis = 0; axis < 3; ++axis)
    {
      *center++ = ParseValue<Real>(spheres[i], axis, size);
    }
    const Real value = ParseValue<Real>(spheres[i], 3, size);
    *radius++ = size == SphereSize::Diameter ? value * Real(0.5) : value;
    if (i % batch == 0)
    {
      progress.Report(static_cast<double>(i) / static_cast<double>(spheres.size()));
    }
  }
}
}

//------------------------------------------------------------------------------
PackingArrays ParseSpheres(
  const std::vector<SphereFields>& spheres, SphereSize size, bool single, Progress& progress)
{
  PackingArrays arrays(static_cast<vtkIdType>(spheres.size()), single);
  const auto fill = single ? Fill<float> : Fill<double>;
  fill(arrays, spheres, size, progress);
  return arrays;
}

//------------------------------------------------------------------------------
void AddIntegers(PackingArrays& arrays, const char* name, const std::vector<int>& values)
{
  const auto array = vtkSmartPointer<vtkIntArray>::New();
  array->SetName(name);
  array->SetNumberOfValues(static_cast<vtkIdType>(values.size()));
  std::copy(values.begin(), values.end(), array->GetPointer(0));
  arrays.AddArray(array);
}
}
