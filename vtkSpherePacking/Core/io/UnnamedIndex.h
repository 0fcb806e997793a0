// SPDX-License-Identifier: BSD-3-Clause
#ifndef UnnamedIndex_h
#define UnnamedIndex_h

#include "io/Separators.h"
#include "io/TextLines.h"

#include <cstddef>

namespace spherepacking
{
/// Whether the first field of rows, for which their header has no name, is an index.
enum class UnnamedIndex : unsigned char
{
  None,     ///< it does not count from 0 or 1, or only one row
  Possible, ///< it counts
  Certain   ///< and more speaks for it
};

/**
 * Looks at `rows`. An index is certain if it is in quotes, as R writes it, ends left of the first
 * name, which is behind `indent` blanks, as pandas writes it, or counts three rows or more beside
 * fields with a point.
 */
UnnamedIndex FindIndex(const TextRange& rows, const Separators& between, std::size_t indent);
}

#endif
