// SPDX-License-Identifier: BSD-3-Clause
#ifndef PackingCell_h
#define PackingCell_h

#include "bridge/PackingArrays.h"

#include <optional>

class vtkPolyData;

namespace spherepacking
{
/// The simulation cell of a packing from its field arrays, see PackingArrays::SetCell(); none
/// without `cell_vectors`. Without `cell_origin` that is 0, without `cell_periodic` the cell is
/// periodic along all three vectors. Throws a std::invalid_argument for arrays that hold no cell.
std::optional<SimulationCell> FindCell(vtkPolyData* packing);
}

#endif
