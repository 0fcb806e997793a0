// SPDX-License-Identifier: BSD-3-Clause
#ifndef CutFile_h
#define CutFile_h

#include "io/Separators.h"
#include "io/TextLines.h"

namespace spherepacking
{
/// Who writes files of a format.
enum class LineEnds
{
  ByProgram, ///< programs alone, which end every line
  ByPeople   ///< people and their scripts, too, who may leave out the last line end
};

/**
 * Throws if a text that ends without a line end may have been cut within its last row, so that its
 * last number lacks digits. What programs write was cut. What people write was probably not if the
 * last field is written with as many digits as any other of its column or, where there is no other
 * row, as any number of its own; nor if a blank or a comment follows it. A text that ends with a
 * line of comment has no row that could be cut.
 */
void CheckNotCut(const TextRange& rows, LineEnds ends, const Separators& between);

/// The same of what programs write.
void CheckNotCut(const TextRange& rows);
}

#endif
