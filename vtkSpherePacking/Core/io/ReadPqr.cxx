// SPDX-License-Identifier: BSD-3-Clause
#include "io/FileBytes.h"
#include "io/PackingFileError.h"
#include "io/PackingFormats.h"
#include "io/TextTable.h"
#include "io/Utf8Mark.h"

namespace spherepacking
{
namespace
{
// The fields of a PQR record are separated by blanks: ATOM, number, name, residue, chain, number of
// the residue, x, y, z, charge and radius. The chain is optional, so they are counted from the end.
PackingArrays ParsePqr(const FileBytes& bytes, const ReadOptions& options, Progress& progress)
{
  TableLayout layout;
  layout.Rows = RowKind::Atom;
  layout.Columns = { { ColumnRole::X, "x" }, { ColumnRole::Y, "y" }, { ColumnRole::Z, "z" },
    { ColumnRole::Extra, "charge" }, { ColumnRole::Radius, "radius" } };
  layout.Expected = "10 or more that end with x y z charge radius";
  progress.SetRange(0.2, 0.3);
  const TextRange text{ SkipUtf8Mark(bytes.Begin(), bytes.End()), bytes.End() };
  const auto chunks = CutIntoChunks(text, layout.Rows, options.ChunkSize, 0, progress);
  if (CountRows(chunks) == 0)
  {
    ThrowNoSphere("ATOM or HETATM records that end with x y z charge radius");
  }
  progress.SetRange(0.3, 1.0);
  return ParseTable(bytes.End(), layout, chunks, options.Single, progress);
}
}

//------------------------------------------------------------------------------
PackingArrays ReadPqr(const std::string& file, const ReadOptions& options, Progress& progress)
{
  progress.SetRange(0.0, 0.2);
  const FileBytes bytes = FileBytes::Read(file, progress);
  return WithFileName(file, [&] { return ParsePqr(bytes, options, progress); });
}
}
