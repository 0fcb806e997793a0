// SPDX-License-Identifier: BSD-3-Clause
#include "io/FileBytes.h"
#include "io/Number.h"
#include "io/PackingFileError.h"
#include "io/PackingFormats.h"
#include "io/TextTable.h"
#include "io/Utf8Mark.h"

#include "vtkIntArray.h"

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

/**
 * Finds the levels of a sphere tree as cellPACK writes it (G. Johnson et al., "cellPACK: a virtual
 * mesoscope to model and visualize structural systems biology", 2015): the smallest and largest
 * radius, the number of levels, and for each level a count and as many lines.
 */
class TreeScanner
{
public:
  explicit TreeScanner(const TextRange& text)
    : Text(text)
    , Find(text.End)
    , Next(text.Begin)
    , NextLine(text.FirstLine)
  {
  }

  std::vector<Level> Scan()
  {
    if (!this->NextRow())
    {
      ThrowNoSphere("the smallest and the largest radius, then levels of spheres");
    }
    this->ReadNumbers(2, "the smallest and the largest radius");
    const vtkIdType count = this->ReadCount("the number of levels");
    std::vector<Level> levels;
    for (vtkIdType i = 1; i <= count; ++i)
    {
      const std::string name = std::to_string(i);
      const vtkIdType spheres = this->ReadCount("the number of spheres in level " + name);
      levels.push_back({ { this->Next, this->Next, this->NextLine }, spheres });
      for (vtkIdType sphere = 0; sphere < spheres; ++sphere)
      {
        if (!this->NextRow())
        {
          this->ThrowAtEnd(std::to_string(sphere) + " spheres in level " + name,
            std::to_string(spheres) + " as its count says");
        }
      }
      levels.back().Text.End = this->Next;
    }
    if (this->NextRow())
    {
      throw LineError(this->Row.FirstLine,
        "found " + Quote(this->Row.Begin, this->Row.End) + " after the last level, expected " +
          std::to_string(count) + " levels with as many spheres as their counts say");
    }
    return levels;
  }

private:
  bool NextRow()
  {
    while (this->Next != this->Text.End)
    {
      const char* end = this->Find(this->Next);
      this->Row = { SkipBlanks(this->Next, end), end, this->NextLine };
      const bool isRow = IsRow(RowKind::Data, this->Next, end);
      this->Next = SkipLineEnd(end, this->Text.End);
      ++this->NextLine;
      if (isRow)
      {
        return true;
      }
    }
    return false;
  }

  [[noreturn]] void ThrowAtEnd(const std::string& found, const std::string& expected)
  {
    throw LineError(
      this->Row.FirstLine, "found the end of the file after " + found + ", expected " + expected);
  }

  // The current row, which must hold `count` numbers; returns the first.
  double ReadNumbers(std::size_t count, const std::string& what)
  {
    const auto fields = Separators::Liberal().Split(this->Row.Begin);
    double first = 0.0;
    bool good = fields.size() == count;
    for (std::size_t i = 0; good && i < count; ++i)
    {
      double value;
      const char* end = fields[i].data() + fields[i].size();
      good = ParseNumber(fields[i].data(), end, value) == end && std::isfinite(value);
      first = i == 0 ? value : first;
    }
    if (!good)
    {
      throw LineError(this->Row.FirstLine,
        "found " + Quote(this->Row.Begin, this->Row.End) + ", expected " + what);
    }
    return first;
  }

  vtkIdType ReadCount(const std::string& what)
  {
    if (!this->NextRow())
    {
      this->ThrowAtEnd(Quote(this->Row.Begin, this->Row.End), what);
    }
    const double count = this->ReadNumbers(1, what);
    if (!IsCount(count))
    {
      throw LineError(this->Row.FirstLine,
        "found " + Quote(this->Row.Begin, this->Row.End) + ", expected " + what +
          ", a whole number that is not negative");
    }
    return static_cast<vtkIdType>(count);
  }

  TextRange Text;
  LineFinder Find;
  const char* Next;
  vtkIdType NextLine;
  TextRange Row{ nullptr, nullptr, 0 };
};

PackingArrays ParseSphereTree(
  const FileBytes& bytes, const ReadOptions& options, Progress& progress)
{
  const TextRange text{ SkipUtf8Mark(bytes.Begin(), bytes.End()), bytes.End() };
  const std::vector<Level> levels = TreeScanner(text).Scan();

  progress.SetRange(0.2, 0.3);
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
  PackingArrays arrays = ParseTable(bytes.End(), layout, chunks, options.Single, progress);

  const auto numbers = vtkSmartPointer<vtkIntArray>::New();
  numbers->SetName("level");
  numbers->SetNumberOfValues(arrays.GetCount());
  int* to = numbers->GetPointer(0);
  for (std::size_t i = 0; i < levels.size(); ++i)
  {
    to = std::fill_n(to, levels[i].Count, static_cast<int>(i + 1));
  }
  arrays.AddArray(numbers);
  return arrays;
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
