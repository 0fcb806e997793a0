// SPDX-License-Identifier: BSD-3-Clause
#ifndef DumpBox_h
#define DumpBox_h

#include "bridge/PackingArrays.h"

#include <array>
#include <string>
#include <vector>

namespace spherepacking
{
/// The rows of ITEM: BOX BOUNDS in a LAMMPS dump, each of 2, 3 or 4 numbers.
using BoxRows = std::array<std::vector<double>, 3>;

/// Sets origin and vectors from the rows: "lo hi", with "xy", "xz", "yz" as third numbers when
/// tilted, in which case lo and hi bound the tilted box (LAMMPS manual, "Triclinic simulation
/// boxes"), or "ax ay az origin" for a general triclinic box.
void SetCellOfBox(const BoxRows& rows, SimulationCell& cell);

/// ITEM: BOX BOUNDS with its rows, in the first of the three forms of which SetCellOfBox() makes
/// this very cell, whatever rounding does; the last can hold any.
std::string BoxOfCell(const SimulationCell& cell);
}

#endif
