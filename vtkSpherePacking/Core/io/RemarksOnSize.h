// SPDX-License-Identifier: BSD-3-Clause
#ifndef RemarksOnSize_h
#define RemarksOnSize_h

#include "io/TextLines.h"

#include <cstddef>
#include <vector>

namespace spherepacking
{
/**
 * Throws if remarks about rows of `count` columns, which are to be read as x, y, z and radius by
 * their places, speak of a diameter in whatever form or of another fourth column, or give lengths
 * in several units.
 */
void CheckRemarks(const std::vector<TextRange>& remarks, std::size_t count);

/// Throws if the remark does, in "found ..., expected ...".
void CheckNoDiameter(const TextRange& remark, std::size_t count);

/// Throws if the remark speaks of another order than x, y, z, radius.
void CheckOrder(const TextRange& remark, std::size_t count);
}

#endif
