// SPDX-License-Identifier: BSD-3-Clause
#include "io/CutFile.h"
#include "io/FileBytes.h"
#include "io/LineScanner.h"
#include "io/PackingFileError.h"
#include "io/PackingFormats.h"
#include "io/SphereFields.h"
#include "io/TextTable.h"
#include "io/ToolkitTree.h"
#include "io/Utf8Mark.h"

namespace spherepacking
{
namespace
{
/// One level of a sphere tree.
struct Level
{
  TextRange Text;
  vtkIdType Count;
};

// Finds the levels of a sphere tree as cellPACK writes it (G. Johnson et al., "cellPACK: a virtual
// mesoscope to model and visualize structural systems biology", 2015): the smallest and largest
// radius, the number of levels, and for each level a count and as many lines.
std::vector<Level> FindLevels(LineScanner& scanner)
{
  scanner.Numbers(2, "the smallest and the largest radius");
  scanner.Require("the number of levels");
  const vtkIdType count = scanner.Count("the number of levels");
  std::vector<Level> levels;
  for (vtkIdType i = 1; i <= count; ++i)
  {
    const std::string name = std::to_string(i);
    const std::string what = "the number of spheres in level " + name;
    scanner.Require(what);
    const vtkIdType spheres = scanner.Count(what);
    levels.push_back({ scanner.Rest(), spheres });
    for (vtkIdType sphere = 0; sphere < spheres; ++sphere)
    {
      scanner.Require(std::to_string(spheres) + " as its count says",
        std::to_string(sphere) + " spheres in level " + name);
    }
    levels.back().Text.End = scanner.Rest().Begin;
  }
  if (!levels.empty())
  {
    CheckNotCut({ levels[0].Text.Begin, levels.back().Text.End, levels[0].Text.FirstLine },
      LineEnds::ByPeople, Separators::Liberal());
  }
  if (scanner.Next())
  {
    const std::string_view line = scanner.Line();
    throw LineError(scanner.LineNumber(),
      "found " + Quote(line.data(), line.data() + line.size()) +
        " after the last level, expected " + std::to_string(count) +
        " levels with as many spheres as their counts say");
  }
  return levels;
}

PackingArrays ParseLevels(const char* textEnd, const std::vector<Level>& levels,
  const ReadOptions& options, Progress& progress)
{
  std::vector<TextChunk> chunks;
  for (const Level& level : levels)
  {
    const auto more =
      CutIntoChunks(level.Text, RowKind::Data, options.ChunkSize, CountRows(chunks), progress);
    chunks.insert(chunks.end(), more.begin(), more.end());
  }
  if (CountRows(chunks) == 0)
  {
    ThrowNoSphere("at least one in a level");
  }

  TableLayout layout;
  layout.Columns = { { ColumnRole::X, "x" }, { ColumnRole::Y, "y" }, { ColumnRole::Z, "z" },
    { ColumnRole::Radius, "radius" } };
  layout.Expected = DescribeColumns(layout.Columns);
  progress.SetRange(0.3, 1.0);
  PackingArrays arrays = ParseTable(textEnd, layout, chunks, options.Single, progress);

  std::vector<int> numbers;
  for (std::size_t i = 0; i < levels.size(); ++i)
  {
    numbers.insert(numbers.end(), levels[i].Count, static_cast<int>(i + 1));
  }
  AddIntegers(arrays, "level", numbers);
  return arrays;
}

// The second line is the number of levels in cellPACK's trees, and a sphere in the toolkit's.
PackingArrays ParseSphereTree(
  const FileBytes& bytes, const ReadOptions& options, Progress& progress)
{
  const TextRange text{ SkipUtf8Mark(bytes.Begin(), bytes.End()), bytes.End() };
  progress.SetRange(0.2, 1.0);
  LineScanner second(text);
  if (second.Next() && second.Next() && second.Fields().size() > 1)
  {
    return ParseToolkitTree(text, options.Single, progress);
  }
  LineScanner scanner(text);
  if (!scanner.Next())
  {
    ThrowNoSphere("the smallest and the largest radius, then levels of spheres");
  }
  const std::vector<Level> levels = FindLevels(scanner);
  progress.SetRange(0.2, 0.3);
  return ParseLevels(bytes.End(), levels, options, progress);
}
}

//------------------------------------------------------------------------------
PackingArrays ReadSphereTree(
  const std::string& file, const ReadOptions& options, Progress& progress)
{
  progress.SetRange(0.0, 0.2);
  const FileBytes bytes = FileBytes::Read(file, progress);
  return WithFileName(file, [&] { return ParseSphereTree(bytes, options, progress); });
}
}
