// SPDX-License-Identifier: BSD-3-Clause
#include "io/LineCursor.h"
#include "io/MercuryHeader.h"
#include "io/PackingFileError.h"
#include "io/PackingFormats.h"
#include "io/StepRows.h"
#include "io/TimeSteps.h"

#include <algorithm>
#include <cmath>

namespace spherepacking
{
namespace
{
constexpr std::size_t Columns2D = 8;
constexpr std::size_t Columns3D = 14;
constexpr std::size_t MostColumns3D = 16; // programs may add to the rows

Column Center(int axis)
{
  return { static_cast<ColumnRole>(axis), std::string(1, static_cast<char>('x' + axis)) };
}

// The columns of a row: in three dimensions centre, velocity, radius, Euler angles, angular
// velocity and a number that a program may choose, by default the species; in two those that are
// not 0. The seventh of these is the angular velocity times -1, so it gets no name.
std::vector<Column> MercuryColumns(int dimensions, std::size_t count)
{
  const auto extra = [](const char* name) { return Column{ ColumnRole::Extra, name }; };
  const Column radius{ ColumnRole::Radius, "radius" };
  if (dimensions == 2)
  {
    return { Center(0), Center(1), extra("vx"), extra("vy"), radius, extra("angle_z"),
      extra("column_7"), extra("info") };
  }
  std::vector<Column> columns{ Center(0), Center(1), Center(2), extra("vx"), extra("vy"),
    extra("vz"), radius, extra("angle_x"), extra("angle_y"), extra("angle_z"), extra("wx"),
    extra("wy"), extra("wz"), extra("info") };
  while (columns.size() < count)
  {
    columns.push_back({ ColumnRole::Extra, "column_" + std::to_string(columns.size() + 1) });
  }
  return columns;
}

TableLayout LayoutOf(const MercuryHeader& header, LineCursor rows)
{
  const bool flat = header.Dimensions == 2;
  std::size_t count = flat ? Columns2D : Columns3D;
  if (rows.Step() && !flat)
  {
    count = std::clamp(rows.Fields().size(), Columns3D, MostColumns3D);
  }
  TableLayout layout;
  layout.Between = Separators::Blanks();
  layout.Columns = MercuryColumns(header.Dimensions, count);
  layout.Expected = DescribeColumns(layout.Columns);
  return layout;
}

// The file does not say along which axes the domain is periodic.
SimulationCell CellOf(const MercuryHeader& header)
{
  SimulationCell cell{};
  cell.Periodic = { false, false, false };
  for (int axis = 0; axis < 3; ++axis)
  {
    cell.Origin[axis] = header.Least[axis];
    cell.Vectors[axis][axis] = header.Greatest[axis] - header.Least[axis];
  }
  return cell;
}

bool IsBox(const MercuryHeader& header)
{
  return std::equal(header.Least, header.Least + header.Dimensions, header.Greatest,
    [](double least, double greatest) { return least < greatest; });
}

// Whether a text that begins with a step has its header and the first particle.
bool HasHead(const TextRange& text)
{
  LineCursor lines(text);
  int count = 0;
  while (count < 2 && lines.Step())
  {
    count += !lines.Fields().empty();
  }
  return count == 2;
}

PackingArrays ParseMercury(LineBlocks& blocks, const ReadOptions& options, Progress& progress)
{
  blocks.Next();
  while (!HasHead(blocks.Text()) && blocks.Grow())
  {
  }
  LineCursor lines(blocks.Text());
  do
  {
    lines.StepInto("the file", MercuryHeader::Expected);
  } while (lines.Fields().empty());
  const auto header = ParseMercuryHeader(lines.Line());
  if (!header)
  {
    blocks.AddLines([&] { lines.Refuse(MercuryHeader::Expected); });
  }
  StepRows rows{ lines.Rest().Begin, header->Count, lines.Number(), "particles" };
  PackingArrays arrays = ReadStepRows(blocks, rows, LayoutOf(*header, lines), options, progress);
  // A cell without extent along z would be none.
  if (header->Dimensions == 3)
  {
    arrays.SetCell(CellOf(*header));
  }
  arrays.SetTime(header->Time);
  return arrays;
}
}

//------------------------------------------------------------------------------
std::optional<MercuryHeader> ParseMercuryHeader(std::string_view line)
{
  const std::string text = std::string(line) + '\n';
  std::vector<double> numbers;
  for (const std::string_view field : Separators::Blanks().Split(text.data()))
  {
    double value;
    const char* const end = field.data() + field.size();
    if (ParseNumber(field.data(), end, value) != end || !std::isfinite(value) ||
      numbers.size() == 8)
    {
      return std::nullopt;
    }
    numbers.push_back(value);
  }
  if ((numbers.size() != 6 && numbers.size() != 8) || !IsCount(numbers[0]))
  {
    return std::nullopt;
  }
  MercuryHeader header{};
  header.Count = static_cast<vtkIdType>(numbers[0]);
  header.Time = numbers[1];
  header.Dimensions = static_cast<int>(numbers.size() - 2) / 2;
  std::copy_n(numbers.begin() + 2, header.Dimensions, header.Least);
  std::copy_n(numbers.begin() + 2 + header.Dimensions, header.Dimensions, header.Greatest);
  return header;
}

//------------------------------------------------------------------------------
bool BeginsAsMercury(const char* begin, const char* end)
{
  LineCursor lines({ begin, end });
  std::optional<MercuryHeader> header;
  do // the first steps may be empty
  {
    header = lines.Step() ? ParseMercuryHeader(lines.Line()) : std::nullopt;
  } while (header && header->Count == 0);
  if (!header || !lines.Step())
  {
    return false;
  }
  const auto fields = lines.Fields();
  // A last row that was cut has fewer columns, but is still below what can be no row of a table.
  const bool isCut = lines.EndsWithText() && header->Dimensions == 3 && IsBox(*header);
  const bool fits = header->Dimensions == 2
    ? fields.size() == Columns2D
    : (fields.size() >= Columns3D || isCut) && fields.size() <= MostColumns3D;
  return fits && std::all_of(fields.begin(), fields.end(), [](auto f) { return IsNumber(f); });
}

//------------------------------------------------------------------------------
PackingArrays ReadMercury(
  const std::string& file, const TimeStep& step, const ReadOptions& options, Progress& progress)
{
  LineBlocks blocks(file, step.Begin, step.End);
  return WithFileName(file, [&] { return ParseMercury(blocks, options, progress); });
}
}
