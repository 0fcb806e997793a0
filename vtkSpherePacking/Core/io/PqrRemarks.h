// SPDX-License-Identifier: BSD-3-Clause
#ifndef PqrRemarks_h
#define PqrRemarks_h

#include "io/TextLines.h"

namespace spherepacking
{
/// Whether the REMARK records before the first atom say that radii stand in columns before those of
/// the charges, "atom radii in columns 55-62", as files of the AMBER tools do. Without a word the
/// charge comes first.
bool SaysRadiusFirst(const TextRange& text);

/// Whether a REMARK says that the B-factors are radii, as GROMACS writes.
bool SaysRadiiInBFactors(const TextRange& text);
}

#endif
