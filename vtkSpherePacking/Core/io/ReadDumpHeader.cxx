// SPDX-License-Identifier: BSD-3-Clause
#include "io/DumpFile.h"

#include "io/Number.h"
#include "io/PackingFileError.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <string_view>

namespace spherepacking
{
namespace
{
using Fields = std::vector<std::string_view>;

/// Reads the lines of a time step's header in order.
class HeaderScanner
{
public:
  explicit HeaderScanner(const TextRange& text)
    : Text(text)
    , Find(text.End)
    , Next(text.Begin)
    , NextLine(text.FirstLine)
  {
  }

  DumpHeader Scan()
  {
    DumpHeader header{};
    header.Count = -1;
    while (this->Step("ITEM: ATOMS with the names of its columns"))
    {
      const std::string_view title = this->Line;
      const auto is = [&](std::string_view name) { return title.substr(0, name.size()) == name; };
      if (is("ITEM: NUMBER OF ATOMS"))
      {
        header.CountLine = this->NextLine;
        header.Count = this->ReadCount();
      }
      else if (is("ITEM: BOX BOUNDS"))
      {
        this->ReadBox();
      }
      else if (is("ITEM: ATOMS"))
      {
        break;
      }
      else if (!is("ITEM:"))
      {
        throw LineError(this->NextLine - 1,
          "found " + this->QuoteLine() + ", expected a line that begins with ITEM:");
      }
      else
      {
        this->Step("the value of " + this->QuoteLine());
      }
    }
    if (header.Count < 0)
    {
      throw LineError(
        this->NextLine - 1, "found ITEM: ATOMS, expected ITEM: NUMBER OF ATOMS before it");
    }
    this->SetColumns(header.Layout);
    header.Atoms = { this->Next, this->Text.End, this->NextLine };
    return header;
  }

private:
  // Moves on by a line, or throws if that was the last.
  bool Step(const std::string& expected)
  {
    if (this->Next == this->Text.End)
    {
      throw LineError(this->NextLine - 1, "found the end of the step, expected " + expected);
    }
    const char* end = this->Find(this->Next);
    this->Line = std::string_view(this->Next, end - this->Next);
    this->Next = SkipLineEnd(end, this->Text.End);
    ++this->NextLine;
    return true;
  }

  std::string QuoteLine() const
  {
    return Quote(this->Line.data(), this->Line.data() + this->Line.size());
  }

  // The numbers of the next line, which must hold nothing else.
  std::vector<double> ReadNumbers(const std::string& expected)
  {
    this->Step(expected);
    std::vector<double> numbers;
    for (const std::string_view field : Separators::Liberal().Split(this->Line.data()))
    {
      double value;
      const char* end = field.data() + field.size();
      if (ParseNumber(field.data(), end, value) != end || !std::isfinite(value))
      {
        throw LineError(
          this->NextLine - 1, "found " + this->QuoteLine() + ", expected " + expected);
      }
      numbers.push_back(value);
    }
    return numbers;
  }

  vtkIdType ReadCount()
  {
    const std::string expected = "the number of atoms";
    const std::vector<double> numbers = this->ReadNumbers(expected);
    if (numbers.size() != 1 || !IsCount(numbers[0]))
    {
      throw LineError(this->NextLine - 1, "found " + this->QuoteLine() + ", expected " + expected);
    }
    return static_cast<vtkIdType>(numbers[0]);
  }

  // "lo hi" a line, with "xy", "xz", "yz" as third numbers when tilted, in which case lo and hi
  // bound the tilted box (LAMMPS manual, "Triclinic simulation boxes"), or "ax ay az origin" for
  // a general triclinic box.
  void ReadBox()
  {
    std::array<std::vector<double>, 3> rows;
    for (auto& row : rows)
    {
      row = this->ReadNumbers("2 to 4 numbers that bound the box");
      if (row.size() < 2 || row.size() > 4 || row.size() != rows[0].size())
      {
        throw LineError(this->NextLine - 1,
          "found " + this->QuoteLine() + ", expected 2 to 4 numbers that bound the box");
      }
    }
    this->Box = BoxFrame{};
    if (rows[0].size() == 4)
    {
      for (int i = 0; i < 3; ++i)
      {
        std::copy_n(rows[i].begin(), 3, this->Box->Edges[i]);
        this->Box->Origin[i] = rows[i][3];
      }
      return;
    }
    const bool tilted = rows[0].size() == 3;
    const double xy = tilted ? rows[0][2] : 0.0;
    const double xz = tilted ? rows[1][2] : 0.0;
    const double yz = tilted ? rows[2][2] : 0.0;
    rows[0][0] -= std::min({ 0.0, xy, xz, xy + xz });
    rows[0][1] -= std::max({ 0.0, xy, xz, xy + xz });
    rows[1][0] -= std::min(0.0, yz);
    rows[1][1] -= std::max(0.0, yz);
    for (int i = 0; i < 3; ++i)
    {
      this->Box->Origin[i] = rows[i][0];
      this->Box->Edges[i][i] = rows[i][1] - rows[i][0];
    }
    this->Box->Edges[1][0] = xy;
    this->Box->Edges[2][0] = xz;
    this->Box->Edges[2][1] = yz;
  }

  // Sets the columns from the ITEM: ATOMS line. Coordinates may be plain (x), unwrapped (xu),
  // scaled, that is fractions of the box (xs), or both (xsu).
  void SetColumns(TableLayout& layout)
  {
    Fields names = Separators::Liberal().Split(this->Line.data());
    names.erase(names.begin(), names.begin() + 2);
    const std::array<std::array<std::string_view, 3>, 4> families{ { { "x", "y", "z" },
      { "xu", "yu", "zu" }, { "xs", "ys", "zs" }, { "xsu", "ysu", "zsu" } } };
    const auto has = [&](std::string_view name)
    { return std::find(names.begin(), names.end(), name) != names.end(); };
    const auto family = std::find_if(families.begin(), families.end(),
      [&](const auto& axes) { return has(axes[0]) && has(axes[1]) && has(axes[2]); });

    std::optional<std::vector<Column>> columns;
    std::string complaint;
    if (family != families.end())
    {
      Fields plain = names;
      for (std::size_t i = 0; i < names.size(); ++i)
      {
        const auto axis = std::find(family->begin(), family->end(), names[i]);
        plain[i] = axis == family->end() ? names[i] : families[0][axis - family->begin()];
      }
      columns = ColumnsFromNames(plain, complaint);
    }
    if (!columns)
    {
      throw LineError(this->NextLine - 1,
        "found the columns " + this->QuoteLine() +
          ", expected x, y, z (or xu, xs, xsu and so on) and radius or diameter");
    }
    if (!complaint.empty())
    {
      throw LineError(this->NextLine - 1, complaint);
    }
    if (family - families.begin() >= 2)
    {
      if (!this->Box)
      {
        throw LineError(this->NextLine - 1,
          "found centres as fractions of the box, expected ITEM: BOX BOUNDS before them");
      }
      layout.Box = this->Box;
    }
    layout.Columns = *columns;
    layout.Expected = DescribeColumns(layout.Columns);
  }

  TextRange Text;
  LineFinder Find;
  const char* Next;
  vtkIdType NextLine;
  std::string_view Line;
  std::optional<BoxFrame> Box;
};

// Columns of text, such as element, are recognised by the first row.
void MarkText(DumpHeader& header)
{
  LineFinder find(header.Atoms.End);
  for (const char* p = header.Atoms.Begin; p != header.Atoms.End;)
  {
    const char* end = find(p);
    if (IsRow(RowKind::Data, p, end))
    {
      MarkTextColumns(header.Layout, p);
      return;
    }
    p = SkipLineEnd(end, header.Atoms.End);
  }
}

// The atoms end at the next title, which need not be the ITEM: TIMESTEP of the next step.
const char* AtomsEnd(const TextRange& text)
{
  const std::string_view view(text.Begin, text.End - text.Begin);
  for (std::size_t at = view.find("ITEM:"); at != view.npos; at = view.find("ITEM:", at + 1))
  {
    if (at == 0 || IsLineEnd(view[at - 1]))
    {
      return text.Begin + at;
    }
  }
  return text.End;
}
}

//------------------------------------------------------------------------------
DumpHeader ReadDumpHeader(const TextRange& text)
{
  DumpHeader header = HeaderScanner(text).Scan();
  header.Atoms.End = AtomsEnd(header.Atoms);
  MarkText(header);
  return header;
}
}
