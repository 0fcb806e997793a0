// SPDX-License-Identifier: BSD-3-Clause
#include "bridge/RadiusArray.h"

#include "bridge/Guard.h"
#include "bridge/Limits.h"
#include "bridge/SmpParallelFor.h"

#include "vtkDataArray.h"
#include "vtkDataArrayRange.h"
#include "vtkDoubleArray.h"
#include "vtkFloatArray.h"
#include "vtkMath.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"
#include "vtkSMPThreadLocal.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <new>
#include <sstream>
#include <stdexcept>

namespace spherepacking
{
namespace
{
// Calls `work` with a vtkFloatArray or a vtkDoubleArray if the array is one, else with it as it is,
// whose values are then asked for one by one.
template <typename Work>
void WithTypedArray(vtkDataArray* array, const Work& work)
{
  if (auto* floats = vtkFloatArray::FastDownCast(array))
  {
    work(floats);
  }
  else if (auto* doubles = vtkDoubleArray::FastDownCast(array))
  {
    work(doubles);
  }
  else
  {
    work(array);
  }
}

// The lowest index at which a value is unusable, so that the message does not depend on threads.
struct FirstBadValue
{
  vtkIdType Index = std::numeric_limits<vtkIdType>::max();

  template <typename ArrayT>
  void operator()(ArrayT* array, bool allowNegative)
  {
    const auto values = vtk::DataArrayValueRange(array);
    vtkSMPThreadLocal<vtkIdType> firsts(this->Index);
    SmpFor(0, values.size(), 0,
      [&](vtkIdType begin, vtkIdType end)
      {
        vtkIdType& first = firsts.Local();
        for (vtkIdType i = begin; i < end; ++i)
        {
          const double value = static_cast<double>(values[i]);
          if (!std::isfinite(value) || (!allowNegative && value < 0.0))
          {
            first = std::min(first, i);
            return;
          }
        }
      });
    for (const vtkIdType first : firsts)
    {
      this->Index = std::min(this->Index, first);
    }
  }

  static vtkIdType Find(vtkDataArray* array, bool allowNegative)
  {
    FirstBadValue worker;
    WithTypedArray(array, [&](auto* typed) { worker(typed, allowNegative); });
    return worker.Index < array->GetNumberOfValues() ? worker.Index : -1;
  }
};

struct SphereBounds
{
  using Bounds = std::array<double, 6>;

  template <typename PointsT, typename RadiiT>
  void operator()(PointsT* points, RadiiT* radii, double bounds[6])
  {
    const auto centers = vtk::DataArrayTupleRange<3>(points);
    const auto r = vtk::DataArrayValueRange<1>(radii);
    const double inf = std::numeric_limits<double>::infinity();
    Bounds all{ inf, -inf, inf, -inf, inf, -inf };
    const auto widen = [&](vtkIdType begin, vtkIdType end, Bounds& box)
    {
      for (vtkIdType i = begin; i < end; ++i)
      {
        const double radius = static_cast<double>(r[i]);
        for (int axis = 0; axis < 3; ++axis)
        {
          const double x = static_cast<double>(centers[i][axis]);
          box[2 * axis] = std::min(box[2 * axis], x - radius);
          box[2 * axis + 1] = std::max(box[2 * axis + 1], x + radius);
        }
      }
    };
    try
    {
      vtkSMPThreadLocal<Bounds> locals(all);
      SmpFor(0, centers.size(), 0,
        [&](vtkIdType begin, vtkIdType end)
        {
          Bounds box = locals.Local();
          widen(begin, end, box);
          locals.Local() = box;
        });
      for (const Bounds& box : locals)
      {
        for (int axis = 0; axis < 3; ++axis)
        {
          all[2 * axis] = std::min(all[2 * axis], box[2 * axis]);
          all[2 * axis + 1] = std::max(all[2 * axis + 1], box[2 * axis + 1]);
        }
      }
    }
    catch (const std::bad_alloc&)
    {
      // Without threads, which takes no memory: a view that is chosen by these bounds must not
      // depend on that.
      widen(0, centers.size(), all);
    }
    std::copy(all.begin(), all.end(), bounds);
  }
};
}

//------------------------------------------------------------------------------
vtkDataArray* FindRadii(vtkPolyData* packing, const char* name, std::string& message)
{
  message.clear();
  std::ostringstream text;
  const vtkIdType count = packing ? packing->GetNumberOfPoints() : 0;
  if (count == 0)
  {
    return nullptr;
  }
  vtkAbstractArray* found = name ? packing->GetPointData()->GetAbstractArray(name) : nullptr;
  vtkDataArray* radii = vtkDataArray::SafeDownCast(found);
  if (!found)
  {
    text << "found no point array '" << (name ? name : "(null)")
         << "', expected one with the radii";
  }
  else if (!radii)
  {
    text << "the radius array '" << name << "' is a " << found->GetClassName()
         << ", expected a numeric array";
  }
  else if (radii->GetNumberOfComponents() != 1)
  {
    text << "the radius array '" << name << "' has " << radii->GetNumberOfComponents()
         << " components, expected 1";
  }
  else if (radii->GetNumberOfTuples() != count)
  {
    text << "the radius array '" << name << "' has " << radii->GetNumberOfTuples()
         << " values, expected one for each of " << count << " points";
  }
  else if (const vtkIdType bad = FirstBadValue::Find(radii, false); bad >= 0)
  {
    text << "the radius array '" << name << "' holds " << radii->GetTuple1(bad) << " at point "
         << bad << ", expected a finite number that is not negative";
  }
  else
  {
    vtkDataArray* points = packing->GetPoints()->GetData();
    if (const vtkIdType at = FirstBadValue::Find(points, true); at >= 0)
    {
      text << "the centre of point " << at / 3 << " has the coordinate "
           << points->GetComponent(at / 3, static_cast<int>(at % 3))
           << ", expected a finite number";
    }
  }
  message = text.str();
  return message.empty() ? radii : nullptr;
}

//------------------------------------------------------------------------------
vtkDataArray* RadiiOf(vtkPolyData* packing, const std::string& name)
{
  std::string message;
  vtkDataArray* radii = FindRadii(packing, name.c_str(), message);
  if (!message.empty())
  {
    throw std::invalid_argument(message);
  }
  return radii;
}

//------------------------------------------------------------------------------
void CheckCount(vtkIdType spheres)
{
  if (spheres > MaxSpheres)
  {
    Refuse(
      "packing", std::to_string(spheres) + " spheres", "at most " + std::to_string(MaxSpheres));
  }
}

//------------------------------------------------------------------------------
void ComputeBounds(vtkPolyData* packing, vtkDataArray* radii, double bounds[6])
{
  if (!packing || !radii || packing->GetNumberOfPoints() == 0)
  {
    vtkMath::UninitializeBounds(bounds);
    return;
  }
  SphereBounds worker;
  WithTypedArray(packing->GetPoints()->GetData(), [&](auto* points)
    { WithTypedArray(radii, [&](auto* typedRadii) { worker(points, typedRadii, bounds); }); });
}
}
