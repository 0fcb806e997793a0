// SPDX-License-Identifier: BSD-3-Clause
#ifndef LammpsAtomStyle_h
#define LammpsAtomStyle_h

#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace spherepacking
{
/**
 * The columns of a row of the section Atoms by the atom_style, such as "sphere" or "hybrid charge
 * sphere", as the LAMMPS manual lists them under read_data; those of a hybrid are id, type, x, y, z
 * and then what the parts add, each once. Nothing for a style that is not known.
 */
std::optional<std::vector<std::string>> ColumnsOfAtomStyle(std::string_view style);
}

#endif
