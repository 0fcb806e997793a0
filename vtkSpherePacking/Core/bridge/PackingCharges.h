// SPDX-License-Identifier: BSD-3-Clause
// The spheres that a field is made of.
#ifndef PackingCharges_h
#define PackingCharges_h

#include "metaballs/multipole/ChargeTree.h"

#include "vtkType.h"

#include <vector>

class vtkDataArray;
class vtkPolyData;

namespace spherepacking
{
class FieldInput
{
public:
  // Uses the `count` largest spheres, those of lower numbers first where they are equal, and gives
  // each of an equal share of them one of the weights. `radii` may be null, for no spheres.
  FieldInput(
    vtkPolyData* packing, vtkDataArray* radii, vtkIdType count, const std::vector<double>& weights);

  // The spheres as (x - origin) scale, with parts of the largest weight for strengths.
  std::vector<Charge> Scaled(const double (&origin)[3], double scale) const;

  bool Empty() const { return this->Number == 0; }

  double Centers[6]; // box of the centres
  double Bounds[6];  // box of the spheres
  double MostWeight = 0.0;

private:
  double WeightOf(vtkIdType rank) const;

  vtkPolyData* Packing;
  vtkDataArray* Radii;
  std::vector<double> Weights;
  std::vector<std::int32_t> Ranks; // from large to small; empty if all have one weight
  vtkIdType Number = 0;
};
}

#endif
