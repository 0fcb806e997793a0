// SPDX-License-Identifier: BSD-3-Clause
#include "io/CutFile.h"
#include "io/FileBytes.h"
#include "io/LineScanner.h"
#include "io/PackLsdHeader.h"
#include "io/PackingFileError.h"
#include "io/PackingFormats.h"
#include "io/SphereFields.h"
#include "io/TextTable.h"
#include "io/Utf8Mark.h"

#include <algorithm>

namespace spherepacking
{
namespace
{
// The centres, each with its diameter unless the header has one per species.
PackingArrays ParsePackLsd(const TextRange& text, bool single, Progress& progress)
{
  LineScanner scanner(text, "!");
  const PackLsdHeader header = ReadPackLsdHeader(scanner);
  const bool diameters = header.Diameters.empty();
  const std::string expected = diameters ? "x y z diameter" : "x y z";
  std::vector<SphereFields> spheres;
  std::vector<int> species;
  for (std::size_t kind = 0; kind < header.Counts.size(); ++kind)
  {
    for (vtkIdType i = 0; i < header.Counts[kind]; ++i)
    {
      scanner.Require(std::to_string(header.Count) + " as their number in line " +
          std::to_string(header.CountLine) + " says",
        std::to_string(spheres.size()) + " spheres");
      const auto fields = scanner.Fields();
      if (fields.size() != (diameters ? 4 : 3))
      {
        scanner.Refuse(expected);
      }
      SphereFields sphere{ {}, scanner.LineNumber() };
      std::copy(fields.begin(), fields.end(), sphere.Numbers);
      if (!diameters)
      {
        sphere.Numbers[3] = header.Diameters[kind];
      }
      spheres.push_back(sphere);
      species.push_back(static_cast<int>(kind + 1));
    }
  }
  if (scanner.Next())
  {
    scanner.Refuse("the end of the file after " + std::to_string(header.Count) + " spheres");
  }
  CheckNotCut(text);
  if (spheres.empty())
  {
    ThrowNoSphere("lines of " + expected);
  }
  PackingArrays arrays = ParseSpheres(spheres, SphereSize::Diameter, single, progress);
  AddIntegers(arrays, "species", species);
  arrays.SetCell(header.Cell);
  return arrays;
}
}

//------------------------------------------------------------------------------
PackingArrays ReadPackLsd(const std::string& file, const ReadOptions& options, Progress& progress)
{
  progress.SetRange(0.0, 0.2);
  const FileBytes bytes = FileBytes::Read(file, progress);
  progress.SetRange(0.2, 1.0);
  return WithFileName(file,
    [&]
    {
      return ParsePackLsd(
        { SkipUtf8Mark(bytes.Begin(), bytes.End()), bytes.End() }, options.Single, progress);
    });
}
}
