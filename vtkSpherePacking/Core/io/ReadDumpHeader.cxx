// SPDX-License-Identifier: BSD-3-Clause
#include "io/DumpFile.h"

#include "io/DumpBox.h"
#include "io/LineCursor.h"
#include "io/PackingFileError.h"

#include <algorithm>
#include <array>
#include <cstddef>
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
  HeaderScanner(const TextRange& text, Radii radii)
    : Lines(text)
    , RadiiOfAtoms(radii)
  {
  }

  DumpHeader Scan()
  {
    while (true)
    {
      this->Step("ITEM: ATOMS with the names of its columns");
      const std::string_view title = this->Lines.Line();
      const auto is = [&](std::string_view name) { return title.substr(0, name.size()) == name; };
      if (is("ITEM: NUMBER OF ATOMS"))
      {
        this->Header.CountLine = this->Lines.Number() + 1;
        this->Step("the number of atoms");
        this->Header.Count = this->Lines.Count("the number of atoms");
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
        this->Lines.Refuse("a line that begins with ITEM:");
      }
      else
      {
        this->Step("the value of " + this->Lines.Quoted());
      }
    }
    if (this->Header.Count < 0)
    {
      throw LineError(
        this->Lines.Number(), "found ITEM: ATOMS, expected ITEM: NUMBER OF ATOMS before it");
    }
    this->SetColumns(this->Header.Layout);
    this->Header.Atoms = this->Lines.Rest();
    return std::move(this->Header);
  }

private:
  void Step(const std::string& expected)
  {
    this->Lines.StepInto("the step", expected);
    if (this->Lines.EndsWithText())
    {
      throw LineError(this->Lines.Number(),
        "found the end of the file within " + this->Lines.Quoted() + ", expected " + expected);
    }
  }

  // Whether a box is periodic along each axis: the title of most ends with flags such as pp, ff
  // or fs, a letter for each face, of which p is periodic. Old versions of LAMMPS wrote none: then
  // no spheres are joined through walls that may be there.
  static std::array<bool, 3> Periodicity(const Fields& title)
  {
    std::array<bool, 3> periodic{ false, false, false };
    const auto isFlag = [](std::string_view field)
    { return field.size() == 2 && field.find_first_not_of("pfsm") == field.npos; };
    if (title.size() >= 6 && std::all_of(title.end() - 3, title.end(), isFlag))
    {
      std::transform(title.end() - 3, title.end(), periodic.begin(),
        [](std::string_view flag) { return flag == "pp"; });
    }
    return periodic;
  }

  void ReadBox()
  {
    const std::string expected = "2 to 4 numbers that bound the box";
    SimulationCell& cell = this->Header.Cell.emplace();
    cell.Periodic = Periodicity(this->Lines.Fields());
    BoxRows rows;
    for (auto& row : rows)
    {
      this->Step(expected);
      row = this->Lines.Numbers(expected);
      if (row.size() < 2 || row.size() > 4 || row.size() != rows[0].size())
      {
        this->Lines.Refuse(expected);
      }
    }
    SetCellOfBox(rows, cell);
  }

  // Sets the columns from the ITEM: ATOMS line. Coordinates may be plain (x), unwrapped (xu),
  // scaled, that is fractions of the box (xs), or both (xsu).
  void SetColumns(TableLayout& layout)
  {
    layout.Between = Separators::Blanks();
    Fields names = this->Lines.Fields();
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
      columns = ColumnsFromNames(plain, complaint, this->RadiiOfAtoms);
    }
    if (!columns)
    {
      throw LineError(this->Lines.Number(),
        "found the columns " + this->Lines.Quoted() +
          ", expected x, y, z (or xu, xs, xsu and so on) and radius or diameter");
    }
    if (!complaint.empty())
    {
      throw LineError(this->Lines.Number(), complaint);
    }
    if (family - families.begin() >= 2)
    {
      if (!this->Header.Cell)
      {
        throw LineError(this->Lines.Number(),
          "found centres as fractions of the box, expected ITEM: BOX BOUNDS before them");
      }
      layout.Box = this->Header.Cell;
    }
    layout.Columns = *columns;
    layout.Expected = DescribeColumns(layout.Columns);
  }

  LineCursor Lines;
  Radii RadiiOfAtoms;
  DumpHeader Header;
};

// The length of what was written of a next title, if the run was stopped within ITEM:.
std::ptrdiff_t LengthOfCutTitle(const TextRange& text)
{
  constexpr std::string_view title = "ITEM:";
  const char* p = text.End;
  while (p != text.Begin && !IsLineEnd(p[-1]))
  {
    --p;
  }
  const std::string_view last(p, text.End - p);
  return last.size() < title.size() && title.substr(0, last.size()) == last ? last.size() : 0;
}
}

//------------------------------------------------------------------------------
bool HasDumpHeader(const TextRange& text)
{
  LineCursor lines(text);
  while (lines.Step())
  {
    if (lines.Line().substr(0, 11) == "ITEM: ATOMS")
    {
      return true;
    }
  }
  return false;
}

//------------------------------------------------------------------------------
DumpHeader ReadDumpHeader(const TextRange& text, Radii radii)
{
  DumpHeader header = HeaderScanner(text, radii).Scan();
  MarkTextByFirstRow(header.Layout, { header.Atoms.Begin, EndOfAtoms(header.Atoms) });
  return header;
}

//------------------------------------------------------------------------------
const char* EndOfAtoms(const TextRange& text)
{
  const std::string_view view(text.Begin, text.End - text.Begin);
  for (std::size_t at = view.find("ITEM:"); at != view.npos; at = view.find("ITEM:", at + 1))
  {
    if (at == 0 || IsLineEnd(view[at - 1]))
    {
      return text.Begin + at;
    }
  }
  return text.End - LengthOfCutTitle(text);
}
}
