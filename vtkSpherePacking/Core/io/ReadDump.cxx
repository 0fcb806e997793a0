// SPDX-License-Identifier: BSD-3-Clause
#include "io/DumpFile.h"
#include "io/FileBytes.h"
#include "io/PackingFileError.h"
#include "io/PackingFormats.h"
#include "io/TextTable.h"

namespace spherepacking
{
namespace
{
PackingArrays ParseDump(
  const FileBytes& bytes, const DumpStep& step, const ReadOptions& options, Progress& progress)
{
  const DumpHeader header = ReadDumpHeader({ bytes.Begin(), bytes.End(), step.FirstLine });
  progress.SetRange(0.2, 0.3);
  const auto chunks =
    CutIntoChunks(header.Atoms, header.Layout.Rows, options.ChunkSize, 0, progress);
  if (const vtkIdType rows = CountRows(chunks); rows != header.Count)
  {
    throw LineError(header.CountLine,
      "found " + std::to_string(header.Count) + " as the number of atoms, but " +
        std::to_string(rows) + " lines of atoms follow, expected as many");
  }
  if (header.Count == 0)
  {
    ThrowNoSphere("atoms in the time step of line " + std::to_string(step.FirstLine));
  }
  progress.SetRange(0.3, 1.0);
  return ParseTable(bytes.End(), header.Layout, chunks, options.Single, progress);
}
}

//------------------------------------------------------------------------------
PackingArrays ReadDump(
  const std::string& file, const DumpStep& step, const ReadOptions& options, Progress& progress)
{
  progress.SetRange(0.0, 0.2);
  const FileBytes bytes = FileBytes::ReadRange(file, step.Begin, step.End - step.Begin, progress);
  return WithFileName(file, [&] { return ParseDump(bytes, step, options, progress); });
}
}
