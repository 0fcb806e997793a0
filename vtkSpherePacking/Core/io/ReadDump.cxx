// SPDX-License-Identifier: BSD-3-Clause
#include "io/DumpFile.h"
#include "io/GivenColumns.h"
#include "io/PackingFileError.h"
#include "io/PackingFormats.h"
#include "io/StepRows.h"
#include "io/TimeSteps.h"

namespace spherepacking
{
namespace
{
PackingArrays ParseDump(
  LineBlocks& blocks, const TimeStep& step, const ReadOptions& options, Progress& progress)
{
  blocks.Next();
  while (!HasDumpHeader(blocks.Text()) && blocks.Grow())
  {
  }
  const DumpHeader header =
    blocks.AddLines([&] { return ReadDumpHeader(blocks.Text(), RadiiOf(options)); });
  StepRows rows{ header.Atoms.Begin, header.Count, header.CountLine, "atoms" };
  rows.End = EndOfAtoms;
  PackingArrays arrays = ReadStepRows(blocks, rows, header.Layout, options, progress);
  if (header.Cell)
  {
    arrays.SetCell(*header.Cell);
  }
  if (step.Time)
  {
    arrays.SetTime(*step.Time);
  }
  return arrays;
}
}

//------------------------------------------------------------------------------
PackingArrays ReadDump(
  const std::string& file, const TimeStep& step, const ReadOptions& options, Progress& progress)
{
  LineBlocks blocks(file, step.Begin, step.End);
  return WithFileName(file, [&] { return ParseDump(blocks, step, options, progress); });
}
}
