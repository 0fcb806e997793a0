// SPDX-License-Identifier: BSD-3-Clause
#include "io/CutFile.h"
#include "io/FileBytes.h"
#include "io/LineScanner.h"
#include "io/PackingFileError.h"
#include "io/PackingFormats.h"
#include "bridge/PrintableText.h"
#include "io/PdbRecord.h"
#include "io/SphereFields.h"
#include "io/Utf8Mark.h"

#include <algorithm>

namespace spherepacking
{
namespace
{
// Of a line of a PDB file; in a longer one the next has lost its line end.
constexpr std::size_t Columns = 80;

// Whether a line that is no ATOM holds a sphere, or what is left of one whose columns have moved.
bool LooksLikeDamagedSphere(std::string_view line)
{
  return HoldsCoordinates(line) || line.size() > Columns ||
    line.find(" SPH ") != std::string_view::npos;
}

/**
 * Reads the spheres of a pore that HOLE writes (O. Smart et al., "HOLE: a program for the analysis
 * of the pore dimensions of ion channel structural models", 1996), as records of atoms in the
 * columns of a PDB file: QSS for a sphere, QC1 and QC2 for the two ends of a capsule; the number of
 * the plane as number of the residue, -888 or -999 for spheres besides that of the plane; the
 * radius as occupancy. LAST-REC-END follows a sphere that only bounds the pore.
 */
PackingArrays ParseHole(const TextRange& text, bool single, Progress& progress)
{
  std::vector<SphereFields> spheres;
  std::vector<int> planes;
  std::vector<int> ends;
  std::vector<std::string_view> names;
  LineScanner scanner(text, {});
  while (scanner.Next())
  {
    const std::string_view line = scanner.WholeLine();
    if (IsAtomRecord(line.data(), line.data() + line.size()))
    {
      int plane;
      if (!HoldsCoordinates(line) || !HoldsFixedNumber(line, 55, 60, 2) ||
        !ParseInteger(PdbColumns(line, 23, 26), plane) || line.size() > Columns)
      {
        scanner.Refuse("a plane in columns 23 to 26, x y z in 31 to 54 and a radius in 55 to 60");
      }
      spheres.push_back({ { PdbColumns(line, 31, 38), PdbColumns(line, 39, 46),
                            PdbColumns(line, 47, 54), PdbColumns(line, 55, 60) },
        scanner.LineNumber() });
      planes.push_back(plane);
      ends.push_back(0);
      names.push_back(PdbColumns(line, 13, 16));
    }
    else if (scanner.Line() == "LAST-REC-END" && !ends.empty())
    {
      ends.back() = 1;
    }
    else if (LooksLikeDamagedSphere(line))
    {
      scanner.Refuse("ATOM or a line without coordinates");
    }
  }
  CheckNotCut(text);
  if (spheres.empty())
  {
    ThrowNoSphere("records ATOM with x y z and a radius");
  }
  PackingArrays arrays = ParseSpheres(spheres, SphereSize::Radius, single, progress);
  AddIntegers(arrays, "plane", planes);
  AddIntegers(arrays, "end", ends);
  std::transform(names.begin(), names.end(), arrays.AddText("name"),
    [](const auto& name) { return PrintableText(name); });
  return arrays;
}
}

//------------------------------------------------------------------------------
PackingArrays ReadHole(const std::string& file, const ReadOptions& options, Progress& progress)
{
  progress.SetRange(0.0, 0.2);
  const FileBytes bytes = FileBytes::Read(file, progress);
  progress.SetRange(0.2, 1.0);
  return WithFileName(file,
    [&]
    {
      return ParseHole(
        { SkipUtf8Mark(bytes.Begin(), bytes.End()), bytes.End() }, options.Single, progress);
    });
}
}
