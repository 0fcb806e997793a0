// SPDX-License-Identifier: BSD-3-Clause
#ifndef TextTable_h
#define TextTable_h

#include "bridge/PackingArrays.h"
#include "io/Progress.h"
#include "io/TableLayout.h"
#include "io/TextChunks.h"

#include <memory>
#include <optional>
#include <utility>
#include <vector>

namespace spherepacking
{
struct ExtraColumns;

/// Parses rows in parallel, piece by piece, into arrays of single or double precision.
class TableParser
{
public:
  /// Makes arrays of `count` rows.
  TableParser(const TableLayout& layout, vtkIdType count, bool single);
  ~TableParser();

  const TableLayout& Layout() const { return this->Rows; }
  vtkIdType Count() const { return this->Arrays.GetCount(); }

  /// Parses the rows of `chunks`, or throws a LineError for the first that does not fit. `textEnd`
  /// is the end of the text that holds the chunks.
  void Parse(const char* textEnd, const std::vector<TextChunk>& chunks, Progress& progress);

  /// If a column of numbers turned out to be text, the layout in which it is that: all has to be
  /// parsed again by it, since the text of the rows before is gone.
  std::optional<TableLayout> LayoutWithText() const;

  /// The arrays, when all rows are parsed.
  PackingArrays Take() { return std::move(this->Arrays); }

private:
  TableLayout Rows;
  PackingArrays Arrays;
  std::unique_ptr<ExtraColumns> Extras;
};

/// Parses the rows of `chunks`, which are all, as a TableParser does.
PackingArrays ParseTable(const char* textEnd, const TableLayout& layout,
  const std::vector<TextChunk>& chunks, bool single, Progress& progress);

/// Throws if a row of the text has too few columns.
void CheckNoShortRow(const TextRange& text, const TableLayout& layout);

/// Throws unless there are as many rows, "atoms" say, as the file says in `line`.
void CheckCount(vtkIdType count, const char* things, vtkIdType line, vtkIdType rows);
}

#endif
