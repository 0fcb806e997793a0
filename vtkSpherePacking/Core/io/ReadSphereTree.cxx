// SPDX-License-Identifier: BSD-3-Clause
#include "io/FileBytes.h"
#include "io/LineScanner.h"
#include "io/Number.h"
#include "io/PackingFileError.h"
#include "io/PackingFormats.h"
#include "io/SphereFields.h"
#include "io/TextTable.h"
#include "io/Utf8Mark.h"

#include <algorithm>
#include <cmath>

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

// How many nodes a whole tree has, but not more than `limit` + 1.
vtkIdType CountNodes(vtkIdType levels, vtkIdType degree, vtkIdType limit)
{
  vtkIdType nodes = 0;
  vtkIdType inLevel = 1;
  for (vtkIdType level = 0; level < levels && nodes <= limit; ++level)
  {
    nodes += inLevel;
    inLevel = inLevel > limit / degree ? limit + 1 : inLevel * degree;
  }
  return std::min(nodes, limit + 1);
}

/**
 * Reads a sphere tree of the Sphere-Tree Construction Toolkit (G. Bradshaw and C. O'Sullivan,
 * "Adaptive medial-axis approximation for sphere-tree construction", 2004): the number of levels
 * and of children a node, then x y z radius occupancy of every node, level by level and child by
 * child. A negative radius stands for a node that is not there.
 */
PackingArrays ParseToolkitTree(LineScanner& scanner, bool single, Progress& progress)
{
  const std::string expected = "the numbers of levels and of children a node";
  const std::vector<double> head = scanner.Numbers(2, expected);
  constexpr double most = 1 << 30;
  if (head[0] < 1 || head[1] < 1 || head[0] > most || head[1] > most ||
    head[0] != std::floor(head[0]) || head[1] != std::floor(head[1]))
  {
    scanner.Refuse(expected);
  }
  const auto degree = static_cast<vtkIdType>(head[1]);
  const vtkIdType headLine = scanner.LineNumber();

  std::vector<SphereFields> spheres;
  std::vector<double> occupancy;
  std::vector<int> levels;
  std::vector<int> parents;
  std::vector<int> kept; // for each node, its sphere or -1
  int level = 1;
  vtkIdType levelEnd = 1;
  vtkIdType levelSize = 1;
  for (vtkIdType node = 0; scanner.Next(); ++node)
  {
    if (node == levelEnd)
    {
      ++level;
      levelSize *= degree; // less than the number of lines by now, times the degree
      levelEnd += levelSize;
    }
    const auto fields = scanner.Fields();
    double radius;
    double share;
    if (fields.size() != 5 || !ParseFinite(fields[3], radius) || !ParseFinite(fields[4], share))
    {
      scanner.Refuse("5 columns: x y z radius occupancy");
    }
    if (radius < 0)
    {
      kept.push_back(-1);
      continue;
    }
    kept.push_back(static_cast<int>(spheres.size()));
    spheres.push_back({ { fields[0], fields[1], fields[2], fields[3] }, scanner.LineNumber() });
    occupancy.push_back(share);
    levels.push_back(level);
    parents.push_back(node == 0 ? -1 : kept[(node - 1) / degree]);
  }
  const auto rows = static_cast<vtkIdType>(kept.size());
  if (CountNodes(static_cast<vtkIdType>(head[0]), degree, rows) != rows)
  {
    throw LineError(headLine,
      "found " + NumberText(head[0]) + " levels of " + NumberText(head[1]) +
        " children a node, but " + std::to_string(rows) +
        " lines of nodes follow, expected as many as such a tree has");
  }
  if (spheres.empty())
  {
    ThrowNoSphere("at least one node with a radius that is not negative");
  }
  PackingArrays arrays = ParseSpheres(spheres, SphereSize::Radius, single, progress);
  std::copy(occupancy.begin(), occupancy.end(), arrays.AddExtra("occupancy"));
  AddIntegers(arrays, "level", levels);
  AddIntegers(arrays, "parent", parents);
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
    LineScanner scanner(text);
    scanner.Next();
    return ParseToolkitTree(scanner, options.Single, progress);
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
