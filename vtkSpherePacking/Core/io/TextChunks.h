// SPDX-License-Identifier: BSD-3-Clause
#ifndef TextChunks_h
#define TextChunks_h

#include "io/PdbRecord.h"
#include "io/Progress.h"
#include "io/TextLines.h"

#include <vector>

namespace spherepacking
{
/// Which lines of a text are rows, that is hold a sphere.
enum class RowKind : unsigned char
{
  Data, ///< all but blank ones and those that begin with #
  Atom  ///< the records ATOM and HETATM
};

/// Whether the line that begins at `begin` is a row. `*end` must be a line end, but may be that of
/// a later line.
inline bool IsRow(RowKind kind, const char* begin, const char* end)
{
  if (kind == RowKind::Atom)
  {
    return IsAtomRecord(begin, end);
  }
  begin = SkipBlanks(begin, end);
  return *begin != '#' && !IsLineEnd(*begin);
}

/// Whole lines that one thread parses at a time, and the rows of the output that they become.
struct TextChunk : TextRange
{
  vtkIdType FirstRow = 0;
  vtkIdType Rows = 0;
};

/**
 * Splits `text` at line ends into chunks of about `chunkSize` bytes and counts their lines and rows
 * in parallel, so that each can be parsed by itself straight into its rows of the output, from
 * `firstRow` on. The chunks do not depend on the number of threads.
 */
std::vector<TextChunk> CutIntoChunks(
  const TextRange& text, RowKind kind, vtkIdType chunkSize, vtkIdType firstRow, Progress& progress);

/// The number of rows before and in `chunks`.
inline vtkIdType CountRows(const std::vector<TextChunk>& chunks)
{
  return chunks.empty() ? 0 : chunks.back().FirstRow + chunks.back().Rows;
}
}

#endif
