// SPDX-License-Identifier: BSD-3-Clause
#include "io/EsysSnapshot.h"
#include "io/FileBytes.h"
#include "io/LineCursor.h"
#include "io/PackingFileError.h"
#include "io/PackingFormats.h"
#include "io/TextTable.h"
#include "io/XyzComment.h"

#include "vtksys/SystemTools.hxx"

#include <algorithm>
#include <array>

namespace spherepacking
{
namespace
{
// What a particle is written as, by whether it can rotate, and whether the version of the snapshot
// is 2 or more, which adds the shift across a periodic boundary.
constexpr std::array<std::size_t, 4> ColumnCounts{ 19, 22, 26, 29 };

std::vector<Column> ColumnsOf(std::size_t count)
{
  std::vector<Column> columns{ { ColumnRole::X, "x" }, { ColumnRole::Y, "y" },
    { ColumnRole::Z, "z" }, { ColumnRole::Radius, "radius" } };
  const auto add = [&columns](std::initializer_list<const char*> names)
  {
    for (const char* name : names)
    {
      columns.push_back({ ColumnRole::Extra, name });
    }
  };
  add({ "id", "tag", "mass" });
  add({ "initial_position_x", "initial_position_y", "initial_position_z" });
  add({ "old_position_x", "old_position_y", "old_position_z" });
  add({ "vx", "vy", "vz", "fx", "fy", "fz" });
  if (count == 22 || count == 29)
  {
    add({ "circular_shift_x", "circular_shift_y", "circular_shift_z" });
  }
  if (count >= 26)
  {
    add({ "q0", "q1", "q2", "q3", "wx", "wy", "wz" });
  }
  return columns;
}

bool IsColumnCount(std::size_t count)
{
  return std::find(ColumnCounts.begin(), ColumnCounts.end(), count) != ColumnCounts.end();
}

/// The file that names those of the processes, each of which holds a part of the particles.
struct SnapshotHeader
{
  std::optional<SimulationCell> Cell;
  std::optional<double> Step; ///< the number of the time step
  std::vector<std::string> Parts;
};

/// The particles that one process has written.
struct SnapshotPart
{
  std::string File;
  FileBytes Bytes;
  vtkIdType Count;
  TextRange Rows; ///< and what follows them, which is bonds
  std::size_t Columns;
};

SnapshotHeader ReadHeader(const std::string& file, const TextRange& text)
{
  SnapshotHeader header;
  SimulationCell cell{};
  LineCursor lines(text);
  while (lines.Step())
  {
    const auto fields = lines.Fields();
    // After the version: the number of time steps of the run, their length, and the step.
    if (lines.Number() == 4 && fields.size() == 1 && IsNumber(fields[0]))
    {
      header.Step = lines.Numbers("the time step")[0];
      continue;
    }
    const auto number = [&](std::size_t i)
    {
      double value = 0.0;
      const char* const end = i < fields.size() ? fields[i].data() + fields[i].size() : nullptr;
      if (!end || ParseNumber(fields[i].data(), end, value) != end || !std::isfinite(value))
      {
        lines.Refuse("the numbers of " + std::string(fields[0]));
      }
      return value;
    };
    if (!fields.empty() && fields[0] == "BoundingBox")
    {
      for (int axis = 0; axis < 3; ++axis)
      {
        cell.Origin[axis] = number(1 + axis);
        cell.Vectors[axis][axis] = number(4 + axis) - cell.Origin[axis];
      }
    }
    else if (!fields.empty() && fields[0] == "PeriodicBoundaries")
    {
      for (int axis = 0; axis < 3; ++axis)
      {
        cell.Periodic[axis] = number(1 + axis) != 0.0;
      }
      header.Cell = cell;
    }
    else if (header.Cell && !fields.empty() && fields[0] != "Dimension")
    {
      // The folder is the one in which the program ran, from where people move files away.
      using vtksys::SystemTools;
      for (const std::string_view name : fields)
      {
        header.Parts.push_back(SystemTools::GetFilenamePath(file) +
          (SystemTools::GetFilenamePath(file).empty() ? "" : "/") +
          SystemTools::GetFilenameName(std::string(name)));
      }
    }
  }
  if (header.Parts.empty())
  {
    throw ContentError("holds no names of files, expected BoundingBox, PeriodicBoundaries and the "
                       "files of the processes");
  }
  return header;
}

SnapshotPart ReadPart(const std::string& file, Progress& progress)
{
  SnapshotPart part{ file, FileBytes::Read(file, progress), 0, { nullptr, nullptr }, 0 };
  LineCursor lines({ part.Bytes.Begin(), part.Bytes.End() });
  lines.StepInto("the file", "the number of particles");
  part.Count = lines.Count("the number of particles");
  part.Rows = lines.Rest();
  for (vtkIdType i = 0; i < part.Count; ++i)
  {
    if (!lines.Step())
    {
      CheckCount(part.Count, "particles", 1, i);
    }
    if (i == 0)
    {
      part.Columns = lines.Fields().size();
      if (!IsColumnCount(part.Columns))
      {
        lines.Refuse("19, 22, 26 or 29 columns: x y z radius id tag mass and so on");
      }
    }
  }
  part.Rows.End = lines.Rest().Begin;
  // Otherwise there are more particles than it says.
  if (lines.Step() && !lines.Fields().empty())
  {
    lines.Count("the number of groups of bonds after as many particles as line 1 says");
  }
  return part;
}

PackingArrays ParseParts(
  const std::vector<SnapshotPart>& parts, const ReadOptions& options, Progress& progress)
{
  vtkIdType count = 0;
  std::size_t columns = ColumnCounts[0]; // of an empty snapshot
  for (const SnapshotPart& part : parts)
  {
    columns = part.Count > 0 ? part.Columns : columns;
    count += part.Count;
  }
  TableLayout layout;
  layout.Between = Separators::Blanks();
  layout.Columns = ColumnsOf(columns);
  layout.Expected = DescribeColumns(layout.Columns);
  TableParser parser(layout, count, options.Single);
  vtkIdType row = 0;
  for (const SnapshotPart& part : parts)
  {
    WithFileName(part.File,
      [&]
      {
        const auto chunks = CutIntoChunks(part.Rows, layout.Rows, options.ChunkSize, row, progress);
        CheckCount(part.Count, "particles", 1, std::max(CountRows(chunks), row) - row);
        parser.Parse(part.Bytes.End(), chunks, progress);
        if (parser.LayoutWithText())
        {
          throw ContentError("holds a row with text, expected numbers alone");
        }
      });
    row += part.Count;
  }
  return parser.Take();
}
}

//------------------------------------------------------------------------------
bool BeginsAsEsysSnapshot(const char* begin, const char* end)
{
  LineCursor lines({ begin, end });
  if (!lines.Step())
  {
    return false;
  }
  const auto first = lines.Fields();
  if (first.size() == 2 && first[0] == "V")
  {
    constexpr int atMost = 20; // lines before it
    for (int i = 0; i < atMost && lines.Step(); ++i)
    {
      const auto fields = lines.Fields();
      if (!fields.empty() && fields[0] == "BoundingBox")
      {
        return true;
      }
    }
    return false;
  }
  if (!XyzCount(lines.Line()) || !lines.Step())
  {
    return false;
  }
  const auto fields = lines.Fields();
  return IsColumnCount(fields.size()) &&
    std::all_of(fields.begin(), fields.end(), [](auto field) { return IsNumber(field); });
}

//------------------------------------------------------------------------------
PackingArrays ReadEsysSnapshot(
  const std::string& file, const ReadOptions& options, Progress& progress)
{
  progress.SetRange(0.0, 0.3);
  const FileBytes head = FileBytes::ReadHead(file, 2);
  SnapshotHeader header{ std::nullopt, std::nullopt, { file } };
  if (*head.Begin() == 'V')
  {
    const FileBytes bytes = FileBytes::Read(file, progress);
    header = WithFileName(file, [&] { return ReadHeader(file, { bytes.Begin(), bytes.End() }); });
  }
  std::vector<SnapshotPart> parts;
  for (const std::string& part : header.Parts)
  {
    parts.push_back(WithFileName(part, [&] { return ReadPart(part, progress); }));
  }
  progress.SetRange(0.3, 1.0);
  PackingArrays arrays = ParseParts(parts, options, progress);
  if (header.Cell)
  {
    arrays.SetCell(*header.Cell);
  }
  if (header.Step)
  {
    arrays.SetTime(*header.Step);
  }
  return arrays;
}
}
