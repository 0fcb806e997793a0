// SPDX-License-Identifier: BSD-3-Clause
#ifndef PackingFormats_h
#define PackingFormats_h

#include "bridge/PackingArrays.h"
#include "io/Progress.h"

#include "vtkType.h"

#include <optional>
#include <string>

namespace spherepacking
{
struct TimeStep;

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
  SphereTree,
  LammpsData,
  Xyz,
  Mercury,
  Dock,
  Hole,
  Swc,
  GenGeo,
  MedialAxis,
  Kratos,
  PackLsd,
  EsysSnapshot
};

/// How to read a file.
struct ReadOptions
{
  bool Single = false;         ///< precision of centres and radii
  vtkIdType ChunkSize = 0;     ///< bytes of text that a thread parses at a time, at least
  std::string Columns;         ///< names of the columns of a table, or empty to find them
  bool RadiusOptional = false; ///< whether a file without radii is read, without an array of them
  bool IsFourthRadius = false; ///< whether a table's extension says so, where nothing else does
};

/// The format that the extension of a file stands for; Auto if that is none or several.
Format FormatOfExtension(const std::string& file);

/// Detects the format of `file` by its extension and, where that is not enough, by its first lines.
Format GuessFormat(const std::string& file);

/// Reads a file, one function per format. These open the file and name it in every error. `format`
/// is one of the tables in text.
PackingArrays ReadTextTable(
  const std::string& file, Format format, const ReadOptions& options, Progress& progress);
PackingArrays ReadPqr(const std::string& file, const ReadOptions& options, Progress& progress);
PackingArrays ReadSphereTree(
  const std::string& file, const ReadOptions& options, Progress& progress);
PackingArrays ReadDock(const std::string& file, const ReadOptions& options, Progress& progress);
PackingArrays ReadHole(const std::string& file, const ReadOptions& options, Progress& progress);
PackingArrays ReadSwc(const std::string& file, const ReadOptions& options, Progress& progress);
PackingArrays ReadGenGeo(const std::string& file, const ReadOptions& options, Progress& progress);
PackingArrays ReadMedialAxis(
  const std::string& file, const ReadOptions& options, Progress& progress);
PackingArrays ReadKratos(const std::string& file, const ReadOptions& options, Progress& progress);
PackingArrays ReadPackLsd(const std::string& file, const ReadOptions& options, Progress& progress);
PackingArrays ReadEsysSnapshot(
  const std::string& file, const ReadOptions& options, Progress& progress);
PackingArrays ReadXyzd(const std::string& file, const ReadOptions& options, Progress& progress);

PackingArrays ReadLammpsData(
  const std::string& file, const ReadOptions& options, Progress& progress);

/// Reads one of the time steps that were found in the file, see io/TimeSteps.h.
PackingArrays ReadDump(
  const std::string& file, const TimeStep& step, const ReadOptions& options, Progress& progress);
PackingArrays ReadXyz(
  const std::string& file, const TimeStep& step, const ReadOptions& options, Progress& progress);
PackingArrays ReadMercury(
  const std::string& file, const TimeStep& step, const ReadOptions& options, Progress& progress);

/// Throws a ContentError: "holds no sphere, expected EXPECTED".
[[noreturn]] void ThrowNoSphere(const std::string& expected);

/// The factor for the diameters of an .xyzd file of `count` spheres, if that is known, from the
/// .nfo file of the same name beside it; 1 if there is none. Throws if there is one that cannot be
/// read, does not hold both porosities, each once, or is of another number of spheres.
double DiameterScale(const std::string& xyzdFile, std::optional<vtkIdType> count);
}

#endif
