// SPDX-License-Identifier: BSD-3-Clause
#include "bridge/VectorArrays.h"

#include "bridge/NewArrays.h"
#include "bridge/SmpParallelFor.h"

#include "vtkDoubleArray.h"
#include "vtkPointData.h"
#include "vtkSMPTools.h"
#include "vtkSmartPointer.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <string>
#include <string_view>
#include <unordered_map>
#include <vector>

namespace spherepacking
{
namespace
{
struct Vector
{
  std::string Name;
  std::array<std::string, 3> Components;
};

using Endings = std::array<const char*, 3>;

constexpr std::array<Endings, 5> KnownEndings{ { { "_x", "_y", "_z" }, { "_X", "_Y", "_Z" },
  { ":0", ":1", ":2" }, { "_0", "_1", "_2" }, { "[0]", "[1]", "[2]" } } };

Vector WithEndings(const std::string& name, const std::string& stem, const Endings& endings)
{
  return { name, { stem + endings[0], stem + endings[1], stem + endings[2] } };
}

// The words of LAMMPS, LIGGGHTS and other DEM programs for components, and of the trade for the
// vector.
std::vector<Vector> KnownVectors()
{
  std::vector<Vector> vectors;
  for (const auto& [stem, name] :
    std::array<std::array<const char*, 2>, 8>{ { { "v", "velocity" }, { "V", "velocity" },
      { "f", "force" }, { "omega", "angular_velocity" }, { "w", "angular_velocity" },
      { "tq", "torque" }, { "angmom", "angular_momentum" }, { "mu", "dipole" } } })
  {
    vectors.push_back(WithEndings(name, stem, { "x", "y", "z" }));
  }
  // Those of VTK's files by LIGGGHTS, and of OVITO and ASE in extended XYZ.
  for (const char* const stem : { "v", "vel", "velo", "Velocity" })
  {
    for (const Endings& endings : KnownEndings)
    {
      vectors.push_back(WithEndings("velocity", stem, endings));
    }
  }
  return vectors;
}

// NAME of NAME_x, NAME:0, NAME_0 or NAME[0], with the two that follow; an empty name if `first` is
// no such.
Vector VectorOf(const std::string& first)
{
  for (const Endings& endings : KnownEndings)
  {
    const std::string_view ending = endings[0];
    if (first.size() > ending.size() &&
      std::string_view(first).substr(first.size() - ending.size()) == ending)
    {
      const std::string name = first.substr(0, first.size() - ending.size());
      return WithEndings(name, name, endings);
    }
  }
  return {};
}

// Whether vectors have these components, NaN being equal to NaN.
bool AreParts(const std::array<vtkDoubleArray*, 3>& parts, vtkDataArray* vectors)
{
  for (vtkIdType i = 0; i < vectors->GetNumberOfTuples(); ++i)
  {
    for (int c = 0; c < 3; ++c)
    {
      const double a = parts[c]->GetValue(i);
      const double b = vectors->GetComponent(i, c);
      if (!(a == b || (std::isnan(a) && std::isnan(b))))
      {
        return false;
      }
    }
  }
  return true;
}

// Arrays by name. VTK would compare with every name.
using ArraysByName = std::unordered_map<std::string, vtkAbstractArray*>;

// The array of a vector, or null if a component is missing or the name is taken.
vtkSmartPointer<vtkDoubleArray> JoinComponents(const ArraysByName& arrays, const Vector& vector)
{
  std::array<const double*, 3> from;
  vtkIdType count = 0;
  for (int i = 0; i < 3; ++i)
  {
    const auto found = arrays.find(vector.Components[i]);
    vtkDoubleArray* const part =
      found == arrays.end() ? nullptr : vtkDoubleArray::FastDownCast(found->second);
    if (!part || part->GetNumberOfComponents() != 1)
    {
      return nullptr;
    }
    from[i] = part->GetPointer(0);
    count = part->GetNumberOfTuples();
  }
  if (arrays.count(vector.Name) > 0)
  {
    return nullptr;
  }
  const auto array = vtkSmartPointer<vtkDoubleArray>::New();
  array->SetName(vector.Name.c_str());
  array->SetNumberOfComponents(3);
  array->SetNumberOfTuples(count);
  double* const to = array->GetPointer(0);
  SmpFor(0, count, vtkSMPTools::THRESHOLD,
    [&](vtkIdType first, vtkIdType last)
    {
      for (vtkIdType i = first; i < last; ++i)
      {
        for (int c = 0; c < 3; ++c)
        {
          to[3 * i + c] = from[c][i];
        }
      }
    });
  return array;
}
}

//------------------------------------------------------------------------------
std::array<std::string, 3> ComponentNames(const std::string& vector)
{
  for (const Vector& known : KnownVectors())
  {
    if (known.Name == vector)
    {
      return known.Components;
    }
  }
  return { vector + "_0", vector + "_1", vector + "_2" };
}

//------------------------------------------------------------------------------
bool IsMadeOfParts(vtkPointData* data, vtkDataArray* vectors)
{
  const std::string name = vectors->GetName() ? vectors->GetName() : "";
  if (name.empty() || vectors->GetNumberOfComponents() != 3)
  {
    return false;
  }
  std::vector<Vector> candidates = KnownVectors();
  for (const Endings& endings : KnownEndings)
  {
    candidates.push_back(WithEndings(name, name, endings));
  }
  // Of several AddVectors() takes one, so all have to be the same.
  bool any = false;
  for (const Vector& candidate : candidates)
  {
    std::array<vtkDoubleArray*, 3> parts;
    std::transform(candidate.Components.begin(), candidate.Components.end(), parts.begin(),
      [data](const std::string& part)
      { return vtkDoubleArray::FastDownCast(data->GetAbstractArray(part.c_str())); });
    const bool there = candidate.Name == name &&
      std::all_of(parts.begin(), parts.end(),
        [](vtkDoubleArray* part) { return part && part->GetNumberOfComponents() == 1; });
    if (there && !AreParts(parts, vectors))
    {
      return false;
    }
    any |= there;
  }
  return any;
}

//------------------------------------------------------------------------------
void AddVectors(vtkPointData* data)
{
  std::vector<Vector> vectors = KnownVectors();
  ArraysByName arrays;
  for (int i = 0; i < data->GetNumberOfArrays(); ++i)
  {
    const char* const name = data->GetAbstractArray(i)->GetName();
    arrays.emplace(name ? name : "", data->GetAbstractArray(i));
    if (const Vector vector = VectorOf(name ? name : ""); !vector.Name.empty())
    {
      vectors.push_back(vector);
    }
  }
  std::vector<vtkSmartPointer<vtkAbstractArray>> found;
  for (const Vector& vector : vectors)
  {
    if (const auto joined = JoinComponents(arrays, vector))
    {
      arrays.emplace(vector.Name, joined);
      found.push_back(joined);
    }
  }
  AddNewArrays(data, found);
}
}
