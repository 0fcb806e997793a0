// SPDX-License-Identifier: BSD-3-Clause
#ifndef PackingCharges_h
#define PackingCharges_h

#include "metaballs/field/Charge.h"

#include "vtkType.h"

#include <vector>

class vtkDataArray;
class vtkPolyData;

namespace spherepacking
{
struct SphereArrays;

/// The largest spheres of a packing, with their weights, as charges of a field.
///
/// Spheres are ranked by radius from large to small, equal ones by their number. The ranks are
/// divided into as many equal parts as there are weights, and each part has one of them.
class PackingCharges
{
public:
  /// Takes the `count` largest spheres, all if it is 0; one weight of 1 if there is none. `radii`
  /// may be null, for no spheres. Packing and radii have to outlive this.
  PackingCharges(
    vtkPolyData* packing, vtkDataArray* radii, vtkIdType count, const std::vector<double>& weights);

  /// Charges at (centre - origin) scale, with weights divided by the largest for strengths.
  std::vector<Charge> Scaled(const double (&origin)[3], double scale) const;

  bool Empty() const { return this->Number == 0; }

  double CenterBounds[6]; ///< of the spheres' centres
  double Bounds[6];       ///< of the spheres
  double MaxWeight = 0.0;

private:
  void RankByRadius(const SphereArrays& spheres);
  void FindBounds(const SphereArrays& spheres);
  double WeightOf(vtkIdType rank) const;
  vtkIdType IdAt(vtkIdType rank) const
  {
    return this->IdOfRank.empty() ? rank : this->IdOfRank[rank];
  }

  vtkPolyData* Packing;
  vtkDataArray* Radii;
  std::vector<double> Weights;
  std::vector<std::int32_t> IdOfRank; // empty if ranks make no difference
  vtkIdType Number = 0;
};
}

#endif
