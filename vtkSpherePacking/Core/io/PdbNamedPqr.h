// SPDX-License-Identifier: BSD-3-Clause
#ifndef PdbNamedPqr_h
#define PdbNamedPqr_h

#include "io/TextLines.h"

namespace spherepacking
{
/**
 * Throws if the atoms of what is called a PQR file have occupancy and temperature factor, in their
 * columns of a PDB file with two decimals each, where charge and radius should be. It goes by the
 * first atom, which must have an element in its columns, too, or an occupancy of 1. GROMACS has
 * written charges and radii into these columns; then a remark says so, or a charge that is beyond 0
 * to 1.
 */
void RefusePdb(const TextRange& text);
}

#endif
