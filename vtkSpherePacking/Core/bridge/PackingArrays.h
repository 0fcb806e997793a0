// SPDX-License-Identifier: BSD-3-Clause
#ifndef PackingArrays_h
#define PackingArrays_h

#include "vtkAOSDataArrayTemplate.h"
#include "vtkSmartPointer.h"

#include <string>
#include <vector>

class vtkDataArray;
class vtkPolyData;

namespace spherepacking
{
/**
 * The arrays of a packing while they are filled. Centres and radii have the same precision; further
 * arrays are double, since single precision would round ids beyond 2^24.
 */
class PackingArrays
{
public:
  PackingArrays(vtkIdType count, bool single);

  vtkIdType GetCount() const { return this->Count; }
  bool IsSingle() const { return this->Single; }

  /// Centres, x y z x y z ..., and radii; `Real` must be float if and only if IsSingle().
  template <typename Real>
  Real* Centers() const
  {
    return vtkAOSDataArrayTemplate<Real>::FastDownCast(this->CenterArray)->GetPointer(0);
  }
  template <typename Real>
  Real* Radii() const
  {
    return vtkAOSDataArrayTemplate<Real>::FastDownCast(this->RadiusArray)->GetPointer(0);
  }

  /// Adds a further array, uninitialised, and returns its values.
  double* AddExtra(const std::string& name);

  /// Removes the further array with these values.
  void RemoveExtra(const double* values);

  /// Adds a further array that is filled already.
  void AddArray(vtkSmartPointer<vtkDataArray> array) { this->Extras.push_back(std::move(array)); }

  /// Moves all arrays to `output`, with a vertex per sphere.
  void MoveTo(vtkPolyData* output);

private:
  vtkIdType Count;
  bool Single;
  vtkSmartPointer<vtkDataArray> CenterArray;
  vtkSmartPointer<vtkDataArray> RadiusArray;
  std::vector<vtkSmartPointer<vtkDataArray>> Extras;
};
}

#endif
