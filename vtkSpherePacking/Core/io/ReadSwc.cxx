// SPDX-License-Identifier: BSD-3-Clause
#include "io/CutFile.h"
#include "io/FileBytes.h"
#include "io/LineScanner.h"
#include "io/PackingFileError.h"
#include "io/PackingFormats.h"
#include "io/TextTable.h"
#include "io/Utf8Mark.h"

namespace spherepacking
{
namespace
{
// The samples of a neuron (R. Cannon et al., "An on-line archive of reconstructed hippocampal
// neurons", 1998): a table whose first seven columns are fixed. Further ones, such as those of the
// extended files of Vaa3D (.eswc), keep their number.
PackingArrays ParseSwc(const FileBytes& bytes, const ReadOptions& options, Progress& progress)
{
  const TextRange text{ SkipUtf8Mark(bytes.Begin(), bytes.End()), bytes.End() };
  CheckNotCut(text);
  LineScanner scanner(text);
  if (!scanner.Next())
  {
    ThrowNoSphere("lines of id type x y z radius parent");
  }
  TableLayout layout;
  layout.Columns = { { ColumnRole::Extra, "id" }, { ColumnRole::Extra, "type" },
    { ColumnRole::X, "x" }, { ColumnRole::Y, "y" }, { ColumnRole::Z, "z" },
    { ColumnRole::Radius, "radius" }, { ColumnRole::Extra, "parent" } };
  for (std::size_t i = layout.Columns.size(); i < scanner.Fields().size(); ++i)
  {
    layout.Columns.push_back({ ColumnRole::Extra, "column_" + std::to_string(i + 1) });
  }
  layout.Expected = DescribeColumns(layout.Columns);
  progress.SetRange(0.2, 0.3);
  const auto chunks = CutIntoChunks(text, RowKind::Data, options.ChunkSize, 0, progress);
  progress.SetRange(0.3, 1.0);
  return ParseTable(bytes.End(), layout, chunks, options.Single, progress);
}
}

//------------------------------------------------------------------------------
PackingArrays ReadSwc(const std::string& file, const ReadOptions& options, Progress& progress)
{
  progress.SetRange(0.0, 0.2);
  const FileBytes bytes = FileBytes::Read(file, progress);
  return WithFileName(file, [&] { return ParseSwc(bytes, options, progress); });
}
}
