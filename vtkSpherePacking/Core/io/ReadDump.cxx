// SPDX-License-Identifier: BSD-3-Clause
#include "io/GivenColumns.h"
#include "io/DumpFile.h"
#include "io/FileBytes.h"
#include "io/PackingFileError.h"
#include "io/PackingFormats.h"
#include "io/TextTable.h"
#include "io/TimeSteps.h"

namespace spherepacking
{
namespace
{
PackingArrays ParseDump(
  const FileBytes& bytes, const TimeStep& step, const ReadOptions& options, Progress& progress)
{
  const DumpHeader header =
    ReadDumpHeader({ bytes.Begin(), bytes.End(), step.FirstLine }, RadiiOf(options));
  CheckNotCut(header.Atoms);
  progress.SetRange(0.2, 0.3);
  const auto chunks =
    CutIntoChunks(header.Atoms, header.Layout.Rows, options.ChunkSize, 0, progress);
  CheckCount(header.Count, "atoms", header.CountLine, chunks);
  progress.SetRange(0.3, 1.0);
  PackingArrays arrays = ParseTable(bytes.End(), header.Layout, chunks, options.Single, progress);
  if (header.Cell)
  {
    arrays.SetCell(*header.Cell);
  }
  arrays.SetTime(*step.Time);
  return arrays;
}
}

//------------------------------------------------------------------------------
PackingArrays ReadDump(
  const std::string& file, const TimeStep& step, const ReadOptions& options, Progress& progress)
{
  progress.SetRange(0.0, 0.2);
  const FileBytes bytes = FileBytes::ReadRange(file, step.Begin, step.End - step.Begin, progress);
  return WithFileName(file, [&] { return ParseDump(bytes, step, options, progress); });
}
}
