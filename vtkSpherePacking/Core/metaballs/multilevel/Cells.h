// SPDX-License-Identifier: BSD-3-Clause
#ifndef Cells_h
#define Cells_h

#include "metaballs/multilevel/GridHierarchy.h"

namespace spherepacking
{
struct ChargeBox
{
  double Low[3];
  double High[3];
};

/// The box of the places of charges, of which there are some.
ChargeBox BoxOf(const std::vector<Charge>& charges);

/// Gives a mesh, whose finest nodes are set, its charges, cell by cell, and the cells. Sorts in
/// place: twice as many would be more memory than all the rest.
void SortIntoCells(std::vector<Charge>&& charges, FieldMesh& mesh, const ParallelFor& parallelFor);
}

#endif
