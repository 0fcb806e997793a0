// SPDX-License-Identifier: BSD-3-Clause
#include "io/FileBytes.h"
#include "io/NamelessColumns.h"
#include "io/PackingFileError.h"
#include "io/PackingFormats.h"
#include "io/TableDetector.h"
#include "io/TextTable.h"
#include "io/Utf8Mark.h"

namespace spherepacking
{
namespace
{
PackingArrays ParseTextTable(
  const FileBytes& bytes, Format format, const ReadOptions& options, Progress& progress)
{
  TextRange text{ SkipUtf8Mark(bytes.Begin(), bytes.End()), bytes.End() };
  const TableLayout layout = DetectTable(format, options, text);
  progress.SetRange(0.2, 0.3);
  const auto chunks = CutIntoChunks(text, layout.Rows, options.ChunkSize, 0, progress);
  if (layout.IsNameless)
  {
    CheckFirstColumn(text, layout);
  }
  progress.SetRange(0.3, 1.0);
  PackingArrays arrays = ParseTable(bytes.End(), layout, chunks, options.Single, progress);
  if (layout.IsNameless)
  {
    CheckFirstRow(text, layout, arrays);
  }
  return arrays;
}
}

//------------------------------------------------------------------------------
PackingArrays ReadTextTable(
  const std::string& file, Format format, const ReadOptions& options, Progress& progress)
{
  progress.SetRange(0.0, 0.2);
  const FileBytes bytes = FileBytes::Read(file, progress);
  return WithFileName(file, [&] { return ParseTextTable(bytes, format, options, progress); });
}
}
