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
 * The arrays of a packing while a format fills them in. Centres and radii have one precision;
 * further arrays are double, since single precision would spoil ids beyond 2^24.
 */
class PackingArrays
{
public:
  PackingArrays(vtkIdType count, bool single);

  vtkIdType GetCount() const { return this->Count; }
  bool IsSingle() const { return this->Single; }

  /// Centres, x y z x y z ..., and radii; `Real` must be float exactly when IsSingle().
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

  /// A further array, uninitialised.
  double* AddExtra(const std::string& name);

  /// Drops the further array that `values` belongs to.
  void RemoveExtra(const double* values);

  /// A further array that is complete.
  void AddArray(vtkSmartPointer<vtkDataArray> array) { this->Extras.push_back(std::move(array)); }

  /// Hands all over to `output`, with a vertex for each sphere.
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
