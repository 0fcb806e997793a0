// SPDX-License-Identifier: BSD-3-Clause
#include "io/FileBytes.h"
#include "io/LineScanner.h"
#include "io/PackingFileError.h"
#include "io/PackingFormats.h"
#include "io/TextTable.h"
#include "io/Utf8Mark.h"

#include <algorithm>

namespace spherepacking
{
namespace
{
// The lines before the particles of a geometry file.
struct GeoHeader
{
  std::optional<SimulationCell> Cell;
  vtkIdType Count = 0;
  vtkIdType CountLine = 0;
};

void SetBox(const LineScanner& scanner, GeoHeader& header)
{
  const std::string expected = "BoundingBox with the 6 coordinates of two corners";
  const auto fields = scanner.Fields();
  double corners[6];
  bool good = fields.size() == 7;
  for (std::size_t i = 0; good && i < 6; ++i)
  {
    good = ParseFinite(fields[i + 1], corners[i]);
  }
  if (!good)
  {
    scanner.Refuse(expected);
  }
  SimulationCell cell{};
  cell.Periodic = { false, false, false };
  for (int axis = 0; axis < 3; ++axis)
  {
    cell.Origin[axis] = corners[axis];
    cell.Vectors[axis][axis] = corners[axis + 3] - corners[axis];
  }
  header.Cell = cell;
}

void SetPeriodic(const LineScanner& scanner, GeoHeader& header)
{
  const auto fields = scanner.Fields();
  for (std::size_t axis = 0; axis < 3; ++axis)
  {
    if (fields.size() != 4 || (fields[axis + 1] != "0" && fields[axis + 1] != "1"))
    {
      scanner.Refuse("PeriodicBoundaries with 3 numbers, 0 or 1");
    }
    if (header.Cell)
    {
      header.Cell->Periodic[axis] = fields[axis + 1] == "1";
    }
  }
}

// Reads up to the number of particles.
GeoHeader ReadHeader(LineScanner& scanner)
{
  const std::string first = "LSMGeometry and a version";
  if (!scanner.Next())
  {
    ThrowNoSphere(first);
  }
  if (scanner.Fields()[0] != "LSMGeometry")
  {
    scanner.Refuse(first);
  }
  GeoHeader header;
  for (;;)
  {
    scanner.Require("BeginParticles");
    const std::string_view word = scanner.Fields()[0];
    if (word == "BoundingBox")
    {
      SetBox(scanner, header);
    }
    else if (word == "PeriodicBoundaries")
    {
      SetPeriodic(scanner, header);
    }
    else if (word == "BeginParticles")
    {
      break;
    }
    else if (word != "Dimension" && word != "Dimensions")
    {
      scanner.Refuse("BoundingBox, PeriodicBoundaries, Dimension or BeginParticles");
    }
  }
  scanner.Require("Simple");
  if (scanner.Line() != "Simple")
  {
    scanner.Refuse("Simple, the kind of particles that are spheres");
  }
  scanner.Require("the number of particles");
  header.Count = scanner.Count("the number of particles");
  header.CountLine = scanner.LineNumber();
  return header;
}

// The lines up to EndParticles.
TextRange FindParticles(LineScanner& scanner)
{
  TextRange particles = scanner.Rest();
  const std::string_view view(particles.Begin, particles.End - particles.Begin);
  const std::size_t end = view.find("EndParticles");
  if (end == view.npos)
  {
    while (scanner.Next())
    {
    }
    scanner.Require("EndParticles");
  }
  particles.End = particles.Begin + end;
  return particles;
}

/**
 * Reads a geometry file of GenGeo, which ESyS-Particle reads, too (S. Abe et al., "ESyS-Particle
 * tutorial and user's guide", 2014): a box, the particles with x y z radius id tag, and which of
 * them are bonded, which is left out.
 */
PackingArrays ParseGenGeo(const FileBytes& bytes, const ReadOptions& options, Progress& progress)
{
  LineScanner scanner({ SkipUtf8Mark(bytes.Begin(), bytes.End()), bytes.End() });
  const GeoHeader header = ReadHeader(scanner);
  const TextRange particles = FindParticles(scanner);
  progress.SetRange(0.2, 0.3);
  const auto chunks = CutIntoChunks(particles, RowKind::Data, options.ChunkSize, 0, progress);
  if (const vtkIdType rows = CountRows(chunks); rows != header.Count)
  {
    throw LineError(header.CountLine,
      "found " + std::to_string(header.Count) + " as the number of particles, but " +
        std::to_string(rows) + " lines of particles follow, expected as many");
  }
  if (header.Count == 0)
  {
    ThrowNoSphere("particles between BeginParticles and EndParticles");
  }
  TableLayout layout;
  layout.Columns = { { ColumnRole::X, "x" }, { ColumnRole::Y, "y" }, { ColumnRole::Z, "z" },
    { ColumnRole::Radius, "radius" }, { ColumnRole::Extra, "id" }, { ColumnRole::Extra, "tag" } };
  layout.Expected = DescribeColumns(layout.Columns);
  progress.SetRange(0.3, 1.0);
  PackingArrays arrays = ParseTable(bytes.End(), layout, chunks, options.Single, progress);
  if (header.Cell)
  {
    arrays.SetCell(*header.Cell);
  }
  return arrays;
}
}

//------------------------------------------------------------------------------
PackingArrays ReadGenGeo(const std::string& file, const ReadOptions& options, Progress& progress)
{
  progress.SetRange(0.0, 0.2);
  const FileBytes bytes = FileBytes::Read(file, progress);
  return WithFileName(file, [&] { return ParseGenGeo(bytes, options, progress); });
}
}
