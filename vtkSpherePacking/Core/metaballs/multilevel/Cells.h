// SPDX-License-Identifier: BSD-3-Clause
#ifndef Cells_h
#define Cells_h

#include "base/Box.h"
#include "metaballs/multilevel/GridHierarchy.h"

namespace spherepacking
{
/// The bounding box of charges, of which there is at least one.
Box BoundsOf(const std::vector<Charge>& charges);

/// Gives a hierarchy, whose finest box of charges is known, its cells and the charges, by a
/// counting sort in place: a second array of charges would take more memory than everything else.
void SortIntoCells(
  std::vector<Charge>&& charges, GridHierarchy& hierarchy, const ParallelFor& parallelFor);
}

#endif
