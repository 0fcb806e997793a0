// SPDX-License-Identifier: BSD-3-Clause
#include "io/CutFile.h"
#include "io/EsysSnapshot.h"
#include "io/FileBytes.h"
#include "io/LineCursor.h"
#include "io/PackingFileError.h"
#include "io/PackingFormats.h"
#include "io/TextTable.h"

#include "vtksys/SystemTools.hxx"

#include <algorithm>
#include <set>

namespace spherepacking
{
namespace
{
constexpr const char* Things = "particles";

/// The particles of one worker.
struct WorkerFile
{
  std::string Path;
  vtkIdType Count;
  std::size_t Columns; ///< in its first row
};

// What the count of a file, its first line, says.
vtkIdType CountOf(LineCursor& lines)
{
  const std::string expected = "the number of particles";
  lines.StepInto("the file", expected);
  return lines.Count(expected);
}

// Looks at the count and the first row; the count is believed only as far as the file is long.
WorkerFile LookAt(const std::string& path)
{
  constexpr unsigned long long head = 1 << 16;
  const FileBytes bytes = FileBytes::ReadHead(path, head);
  return WithFileName(path,
    [&]
    {
      LineCursor lines({ bytes.Begin(), bytes.End() });
      WorkerFile file{ path, CountOf(lines), 0 };
      const vtkIdType countLine = lines.Number();
      file.Columns = file.Count > 0 && lines.Step() ? lines.Fields().size() : 0;
      const auto most = static_cast<vtkIdType>(
        FileBytes::Size(path) / (2 * std::max<std::size_t>(file.Columns, 1)));
      if (file.Count > most)
      {
        throw LineError(countLine,
          "found " + std::to_string(file.Count) +
            " as the number of particles, expected at most as many as the file has room for");
      }
      return file;
    });
}

// Throws if the file of a further worker lies beside those that are named: the program does not end
// the line of their names, which may have been cut between two of them.
void CheckNoFurtherFile(const std::string& folder, const EsysSnapshot& snapshot)
{
  const std::string& last = snapshot.Files.back();
  const std::size_t number = last.rfind('_');
  const std::string name = last.substr(0, number == last.npos ? 0 : number + 1) +
    std::to_string(snapshot.Files.size() + 1) + ".txt";
  if (number != last.npos &&
    vtksys::SystemTools::FileExists(folder.empty() ? name : folder + '/' + name, true))
  {
    throw LineError(snapshot.FilesLine,
      "found " + std::to_string(snapshot.Files.size()) + " files of particles, but " +
        Quote(name.data(), name.data() + name.size()) +
        " beside them, too, expected the names of all (remove it if it is of another run)");
  }
}

std::vector<WorkerFile> FindWorkerFiles(const std::string& head, const EsysSnapshot& snapshot)
{
  const std::string folder = vtksys::SystemTools::GetFilenamePath(head);
  std::vector<WorkerFile> files;
  std::set<std::string> names;
  for (const std::string& name : snapshot.Files)
  {
    if (!names.insert(name).second)
    {
      throw LineError(snapshot.FilesLine,
        "found " + Quote(name.data(), name.data() + name.size()) +
          " twice, expected each file of particles once");
    }
    const std::string path = folder.empty() ? name : folder + '/' + name;
    if (!vtksys::SystemTools::FileExists(path, true))
    {
      throw LineError(snapshot.FilesLine,
        "found " + Quote(name.data(), name.data() + name.size()) +
          ", which is not there, expected the files of particles beside this one");
    }
    files.push_back(LookAt(path));
  }
  CheckNoFurtherFile(folder, snapshot);
  return files;
}

// Particles that rotate have an orientation and an angular velocity at the end.
TableLayout LayoutOf(std::size_t count)
{
  TableLayout layout;
  layout.Between = Separators::Blanks();
  layout.Columns = { { ColumnRole::X, "x" }, { ColumnRole::Y, "y" }, { ColumnRole::Z, "z" },
    { ColumnRole::Radius, "radius" } };
  for (const char* name : { "id", "tag", "mass", "initial_position_x", "initial_position_y",
         "initial_position_z", "old_position_x", "old_position_y", "old_position_z", "vx", "vy",
         "vz", "fx", "fy", "fz", "circular_shift_x", "circular_shift_y", "circular_shift_z", "q0",
         "q1", "q2", "q3", "wx", "wy", "wz" })
  {
    if (layout.Columns.size() < count)
    {
      layout.Columns.push_back({ ColumnRole::Extra, name });
    }
  }
  while (layout.Columns.size() < count)
  {
    layout.Columns.push_back(
      { ColumnRole::Extra, "column_" + std::to_string(layout.Columns.size() + 1) });
  }
  layout.Expected = DescribeColumns(layout.Columns);
  return layout;
}

// The lines of the particles, which bonds and more follow.
TextRange FindRows(LineCursor& lines, vtkIdType count)
{
  const vtkIdType countLine = lines.Number();
  TextRange rows = lines.Rest();
  vtkIdType found = 0;
  while (found < count && lines.Step())
  {
    ++found;
  }
  CheckCount(count, Things, countLine, found);
  rows.End = lines.Rest().Begin;
  if (lines.Step() && !lines.Fields().empty())
  {
    // Otherwise there are more particles than it says.
    lines.Count("the number of groups of bonds after as many particles as line 1 says");
  }
  return rows;
}

// Parses the particles of a worker into the rows from `first` on.
void ParseWorkerFile(const WorkerFile& file, TableParser& parser, vtkIdType first,
  const ReadOptions& options, Progress& progress)
{
  Progress silent(nullptr);
  const FileBytes bytes = FileBytes::Read(file.Path, silent);
  WithFileName(file.Path,
    [&]
    {
      LineCursor lines({ bytes.Begin(), bytes.End() });
      CountOf(lines);
      const TextRange rows = FindRows(lines, file.Count);
      CheckNotCut(rows);
      const auto chunks = CutIntoChunks(rows, RowKind::Data, options.ChunkSize, first, silent);
      CheckCount(file.Count, Things, 1, CountRows(chunks) - (chunks.empty() ? 0 : first));
      parser.Parse(bytes.End(), chunks, progress);
      if (parser.LayoutWithText())
      {
        throw ContentError("found words among the numbers, expected numbers alone");
      }
      return 0;
    });
}
}

//------------------------------------------------------------------------------
PackingArrays ReadEsysSnapshot(
  const std::string& file, const ReadOptions& options, Progress& progress)
{
  const FileBytes head = FileBytes::Read(file, progress);
  EsysSnapshot snapshot{};
  std::vector<WorkerFile> files;
  WithFileName(file,
    [&]
    {
      snapshot = ParseEsysSnapshot({ head.Begin(), head.End() });
      files = FindWorkerFiles(file, snapshot);
      return 0;
    });
  vtkIdType count = 0;
  std::size_t columns = 0;
  for (const WorkerFile& worker : files)
  {
    count += worker.Count;
    columns = std::max(columns, worker.Columns);
  }
  constexpr std::size_t fewest = 7; // up to the mass
  TableParser parser(LayoutOf(std::max(columns, fewest)), count, options.Single);
  vtkIdType first = 0;
  for (const WorkerFile& worker : files)
  {
    ParseWorkerFile(worker, parser, first, options, progress);
    first += worker.Count;
  }
  PackingArrays arrays = parser.Take();
  arrays.SetCell(snapshot.Cell);
  arrays.SetTime(snapshot.Time);
  return arrays;
}
}
