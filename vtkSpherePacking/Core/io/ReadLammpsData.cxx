// SPDX-License-Identifier: BSD-3-Clause
#include "io/CutFile.h"
#include "io/GivenColumns.h"
#include "io/FileBytes.h"
#include "io/LammpsAtomStyle.h"
#include "io/LammpsDataFile.h"
#include "io/LineCursor.h"
#include "io/PackingFileError.h"
#include "io/PackingFormats.h"
#include "io/TextTable.h"
#include "io/Utf8Mark.h"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace spherepacking
{
namespace
{
using Fields = std::vector<std::string_view>;

Fields FirstRow(const TextRange& rows)
{
  LineCursor lines(rows);
  while (lines.Step())
  {
    if (Fields fields = Separators::Liberal().Split(lines.Line().data()); !fields.empty())
    {
      return fields;
    }
  }
  return {};
}

bool IsWhole(std::string_view number)
{
  return number.find_first_of(".eE") == number.npos;
}

// The atom_style of the atoms: that of the comment after the section's name, or else sphere if it
// can be no other. That is if the third of seven numbers is written with a point, which neither a
// type (style full) nor a flag (ellipsoid) is, and it is not the volume of style peri: if the
// velocities are followed by angular ones, or LIGGGHTS, which names no style, wrote the file.
std::string AtomStyle(const LammpsDataFile& file, const Fields& row)
{
  if (ColumnsOfAtomStyle(file.Atoms->Comment))
  {
    return file.Atoms->Comment;
  }
  constexpr std::size_t withAngular = 7;
  const bool fits = (row.size() == 7 || row.size() == 10) && !IsWhole(row[2]);
  const bool turns = file.Velocities && FirstRow(file.Velocities->Rows).size() == withAngular;
  const bool byLiggghts = file.Title.find("LIGGGHTS") != file.Title.npos;
  return fits && (turns || byLiggghts) ? "sphere" : "";
}

std::vector<Column> ColumnsOfStyle(
  const LammpsDataFile& file, const Fields& row, const ReadOptions& options)
{
  const std::string style = AtomStyle(file, row);
  const auto names = ColumnsOfAtomStyle(style);
  if (!names)
  {
    throw LineError(file.Atoms->Line,
      "found rows of " + std::to_string(row.size()) +
        " columns and no atom_style, expected a comment that names it, such as Atoms # sphere, "
        "or columns=\"id type diameter density x y z\" (--columns) to say what they are");
  }
  Fields all(names->begin(), names->end());
  if (row.size() == all.size() + 3)
  {
    all.insert(all.end(), { "ix", "iy", "iz" }); // through which images of the cell the atom went
  }
  std::string complaint;
  auto columns = ColumnsFromNames(all, complaint, RadiiOf(options));
  if (!columns)
  {
    throw LineError(file.Atoms->Line,
      "found atom_style " + style + ", which has no diameter, expected one such as sphere");
  }
  return *columns;
}

TableLayout LayoutOfAtoms(const LammpsDataFile& file, const ReadOptions& options)
{
  TableLayout layout;
  layout.Columns = options.Columns.empty()
    ? ColumnsOfStyle(file, FirstRow(file.Atoms->Rows), options)
    : GivenColumns(options);
  MarkTextByFirstRow(layout, file.Atoms->Rows);
  layout.Expected = DescribeColumns(layout.Columns);
  return layout;
}

// The velocities, as a packing of their own whose centres they are; after them there may be angular
// velocities, or what else the atom_style has.
TableLayout LayoutOfVelocities(const TextRange& rows)
{
  TableLayout layout;
  layout.Columns = { { ColumnRole::Extra, "id" }, { ColumnRole::X, "vx" }, { ColumnRole::Y, "vy" },
    { ColumnRole::Z, "vz" } };
  if (FirstRow(rows).size() == 7)
  {
    for (const char* name : { "wx", "wy", "wz" })
    {
      layout.Columns.push_back({ ColumnRole::Extra, name });
    }
  }
  layout.Expected = DescribeColumns(layout.Columns);
  return layout;
}

/// Finds rows by the id of their atom.
class RowsById
{
public:
  RowsById(const double* ids, vtkIdType count)
    : Ids(ids)
    , Order(count)
  {
    std::iota(this->Order.begin(), this->Order.end(), 0);
    if (!std::is_sorted(ids, ids + count))
    {
      std::sort(this->Order.begin(), this->Order.end(),
        [ids](vtkIdType a, vtkIdType b) { return ids[a] < ids[b]; });
    }
  }

  /// The row of `id`; -1 if there is none or several.
  vtkIdType Find(double id) const
  {
    const auto found = std::lower_bound(this->Order.begin(), this->Order.end(), id,
      [this](vtkIdType row, double other) { return this->Ids[row] < other; });
    const bool there = found != this->Order.end() && this->Ids[*found] == id;
    const bool again = there && found + 1 != this->Order.end() && this->Ids[found[1]] == id;
    return there && !again ? *found : -1;
  }

private:
  const double* Ids;
  std::vector<vtkIdType> Order;
};

void AddVelocities(PackingArrays& atoms, const char* textEnd, const LammpsSection& section,
  const ReadOptions& options, Progress& progress)
{
  const double* const atomIds = atoms.FindExtra("id");
  const TableLayout layout = LayoutOfVelocities(section.Rows);
  const auto chunks = CutIntoChunks(section.Rows, RowKind::Data, options.ChunkSize, 0, progress);
  CheckCount(atoms.GetCount(), "velocities", section.Line, CountRows(chunks));
  const PackingArrays velocities = ParseTable(textEnd, layout, chunks, false, progress);
  const double* const ids = velocities.FindExtra("id");
  if (!atomIds || !ids)
  {
    throw LineError(section.Line, "found velocities of atoms without ids, expected ids of numbers");
  }
  const RowsById rows(atomIds, atoms.GetCount());
  std::vector<vtkIdType> target(atoms.GetCount());
  std::vector<bool> filled(atoms.GetCount());
  for (vtkIdType i = 0; i < atoms.GetCount(); ++i)
  {
    target[i] = rows.Find(ids[i]);
    if (target[i] < 0 || filled[target[i]])
    {
      throw LineError(section.Line,
        "found velocities of an atom " + NumberText(ids[i]) +
          " that is not there or there twice, expected those of each atom");
    }
    filled[target[i]] = true;
  }
  const auto add = [&](const char* name, const double* from, vtkIdType stride)
  {
    double* const to = atoms.AddExtra(name);
    for (vtkIdType i = 0; i < atoms.GetCount(); ++i)
    {
      to[target[i]] = from[stride * i];
    }
  };
  const double* const centers = velocities.Centers<double>();
  add("vx", centers, 3);
  add("vy", centers + 1, 3);
  add("vz", centers + 2, 3);
  for (const char* name : { "wx", "wy", "wz" })
  {
    if (const double* const values = velocities.FindExtra(name))
    {
      add(name, values, 1);
    }
  }
}

// Programs say in the title who they are. People may leave out the last line end, after the
// sections that are read here.
void CheckEnd(const TextRange& text, const LammpsDataFile& file)
{
  const bool byProgram = file.Title.find("via write_data") != file.Title.npos ||
    file.Title.find("LIGGGHTS") != file.Title.npos;
  for (const auto& section : { file.Atoms, file.Velocities })
  {
    if (!byProgram && section && section->Rows.End == text.End)
    {
      CheckNotCut(section->Rows, LineEnds::ByPeople, Separators::Liberal());
      return;
    }
  }
  CheckNotCut(text);
}

PackingArrays ParseLammpsData(
  const FileBytes& bytes, const ReadOptions& options, Progress& progress)
{
  const TextRange text{ SkipUtf8Mark(bytes.Begin(), bytes.End()), bytes.End() };
  const LammpsDataFile file = ScanLammpsData(text);
  CheckEnd(text, file);
  if (file.Count < 0)
  {
    throw ContentError("holds no line with the number of atoms, expected N atoms in the header");
  }
  if (!file.Atoms)
  {
    throw LineError(file.CountLine,
      "found " + std::to_string(file.Count) + " atoms and no section Atoms, expected one");
  }
  const TableLayout layout = LayoutOfAtoms(file, options);
  progress.SetRange(0.2, 0.3);
  const auto chunks =
    CutIntoChunks(file.Atoms->Rows, RowKind::Data, options.ChunkSize, 0, progress);
  CheckCount(file.Count, "atoms", file.CountLine, CountRows(chunks));
  progress.SetRange(0.3, 0.8);
  PackingArrays arrays = ParseTable(bytes.End(), layout, chunks, options.Single, progress);
  if (file.Velocities)
  {
    progress.SetRange(0.8, 1.0);
    AddVelocities(arrays, bytes.End(), *file.Velocities, options, progress);
  }
  if (file.Cell)
  {
    arrays.SetCell(*file.Cell);
  }
  return arrays;
}
}

//------------------------------------------------------------------------------
PackingArrays ReadLammpsData(
  const std::string& file, const ReadOptions& options, Progress& progress)
{
  progress.SetRange(0.0, 0.2);
  const FileBytes bytes = FileBytes::Read(file, progress);
  return WithFileName(file, [&] { return ParseLammpsData(bytes, options, progress); });
}
}
