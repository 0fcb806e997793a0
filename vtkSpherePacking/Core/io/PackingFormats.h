// SPDX-License-Identifier: BSD-3-Clause
#ifndef PackingFormats_h
#define PackingFormats_h

#include "bridge/PackingArrays.h"
#include "io/Progress.h"

#include <string>

namespace spherepacking
{
/// The values of vtkSpherePackingReader::FileFormats.
enum class Format
{
  Auto,
  Spheres,
  Xyzr,
  Yade,
  Csv,
  Xyzd,
  Dump,
  Pqr,
  SphereTree
};

/// What to read and how.
struct ReadOptions
{
  std::string File;
  bool Single = false;
  vtkIdType ChunkSize = 0;
};

/// The format that the name of a file stands for; Auto when there is none or several.
Format FormatOfExtension(const std::string& file);

/// The format of `file` by its extension and, where that leaves a choice, by its first bytes.
Format GuessFormat(const std::string& file);

/// One function a format; `format` is one of the tables in text.
PackingArrays ReadTextTable(const ReadOptions& options, Format format, Progress& progress);
PackingArrays ReadPqr(const ReadOptions& options, Progress& progress);
PackingArrays ReadSphereTree(const ReadOptions& options, Progress& progress);
PackingArrays ReadXyzd(const ReadOptions& options, Progress& progress);

/// One of the steps that FindDumpSteps() found in the file.
struct DumpStep;
PackingArrays ReadDump(const ReadOptions& options, const DumpStep& step, Progress& progress);

/// Throws "FILE: holds no sphere, expected WHAT".
[[noreturn]] void ThrowNoSphere(const std::string& file, const std::string& expected);

/**
 * By what `file`.nfo, beside `file`.xyzd, says the stored diameters have to be multiplied; 1
 * without such a file. Throws when it is there but does not say.
 */
double DiameterScale(const std::string& xyzdFile);
}

#endif
