// SPDX-License-Identifier: BSD-3-Clause
#include "io/CheckPlaces.h"
#include "io/CutFile.h"
#include "io/FileBytes.h"
#include "io/GivenColumns.h"
#include "io/LaterNames.h"
#include "io/PackingFileError.h"
#include "io/PackingFormats.h"
#include "io/TableDetector.h"
#include "io/TextTable.h"
#include "io/UnicodeText.h"
#include "io/Utf8Mark.h"

#include <utility>

namespace spherepacking
{
namespace
{
PackingArrays ParseTextTable(
  FileBytes encoded, Format format, const ReadOptions& options, Progress& progress)
{
  const FileBytes bytes = ToUtf8(std::move(encoded));
  TextRange text{ SkipUtf8Mark(bytes.Begin(), bytes.End()), bytes.End() };
  const TableLayout layout = DetectTable(format, options, text);
  CheckNotCut(text, layout.Ends, layout.Between);
  progress.SetRange(0.2, 0.3);
  const auto chunks = CutIntoChunks(text, RowKind::Data, options.ChunkSize, 0, progress);
  if (options.Columns.empty())
  {
    CheckLaterNames(text, chunks, layout, RadiiOf(options));
  }
  progress.SetRange(0.3, 1.0);
  PackingArrays arrays = ParseTable(bytes.End(), layout, chunks, options.Single, progress);
  CheckPlaces(text, layout, arrays);
  if (layout.Cell)
  {
    arrays.SetCell(*layout.Cell);
  }
  return arrays;
}
}

//------------------------------------------------------------------------------
PackingArrays ReadTextTable(
  const std::string& file, Format format, const ReadOptions& options, Progress& progress)
{
  progress.SetRange(0.0, 0.2);
  FileBytes bytes = FileBytes::Read(file, progress);
  return WithFileName(file,
    [&]
    {
      ReadOptions here = options;
      here.IsFourthRadius = FormatOfExtension(file) == Format::Spheres;
      return ParseTextTable(std::move(bytes), format, here, progress);
    });
}
}
