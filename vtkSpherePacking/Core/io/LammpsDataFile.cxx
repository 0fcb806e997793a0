// SPDX-License-Identifier: BSD-3-Clause
#include "io/LammpsDataFile.h"

#include "io/LineCursor.h"
#include "io/Misspelt.h"
#include "io/PackingFileError.h"

#include <algorithm>
#include <array>

namespace spherepacking
{
namespace
{
using Fields = std::vector<std::string_view>;

bool IsLetter(char c)
{
  return (c >= 'A' && c <= 'Z') || (c >= 'a' && c <= 'z');
}

std::string_view Trim(std::string_view text)
{
  text.remove_prefix(std::min(text.find_first_not_of(" \t"), text.size()));
  text.remove_suffix(text.size() - (text.find_last_not_of(" \t") + 1));
  return text;
}

// The fields of a header line before a comment.
Fields HeaderFields(const LineCursor& lines)
{
  return Separators::Liberal().Split(lines.Line().data());
}

/// Goes through the header, whose lines are numbers and then words that say what these are, and
/// the sections, which begin with a line of words.
class DataScanner
{
public:
  explicit DataScanner(const TextRange& text)
    : Lines(text)
  {
  }

  LammpsDataFile Scan()
  {
    if (this->Lines.Step())
    {
      this->File.Title = this->Lines.Line();
    }
    LammpsSection* section = nullptr; // that is of interest, and in which the scan is
    bool inHeader = true;
    while (this->Lines.Step())
    {
      const std::string_view line = Trim(this->Lines.Line());
      if (!line.empty() && IsLetter(line.front()))
      {
        this->End(section);
        section = this->Begin(line);
        inHeader = false;
      }
      else if (inHeader)
      {
        this->ReadHeaderLine();
      }
    }
    if (section)
    {
      section->Rows.End = this->Lines.Rest().End;
    }
    this->SetCell();
    return std::move(this->File);
  }

private:
  // The section that begins with the current line, if it is of interest.
  LammpsSection* Begin(std::string_view line)
  {
    const std::size_t hash = std::min(line.find('#'), line.size());
    const std::string_view name = Trim(line.substr(0, hash));
    std::optional<LammpsSection>* const to = name == "Atoms" ? &this->File.Atoms
      : name == "Velocities"                                 ? &this->File.Velocities
                                                             : nullptr;
    if (!to)
    {
      if (IsMisspelt(name, "Atoms") || IsMisspelt(name, "Velocities"))
      {
        this->Lines.Refuse("the name of a section, such as Atoms or Velocities");
      }
      return nullptr;
    }
    if (*to)
    {
      throw LineError(this->Lines.Number(),
        "found a second section " + std::string(name) + ", expected one, as in line " +
          std::to_string((*to)->Line));
    }
    const std::string_view comment = hash < line.size() ? line.substr(hash + 1) : "";
    to->emplace(
      LammpsSection{ std::string(Trim(comment)), this->Lines.Number(), this->Lines.Rest() });
    return &**to;
  }

  void End(LammpsSection* section) const
  {
    if (section)
    {
      section->Rows.End = this->Lines.Line().data();
    }
  }

  void ReadHeaderLine()
  {
    const Fields fields = HeaderFields(this->Lines);
    const auto ends = [&](const Fields& words)
    {
      return fields.size() >= words.size() &&
        std::equal(words.begin(), words.end(), fields.end() - words.size());
    };
    if (fields.size() == 2 && ends({ "atoms" }))
    {
      this->File.Count = static_cast<vtkIdType>(this->Numbers(fields, 1, true)[0]);
      this->File.CountLine = this->Lines.Number();
      return;
    }
    constexpr std::array<std::array<const char*, 2>, 3> bounds{ { { "xlo", "xhi" },
      { "ylo", "yhi" }, { "zlo", "zhi" } } };
    constexpr std::array<const char*, 3> vectors{ "avec", "bvec", "cvec" };
    for (std::size_t axis = 0; axis < 3; ++axis)
    {
      if (ends({ bounds[axis][0], bounds[axis][1] }))
      {
        this->Bounds[axis] = this->Numbers(fields, 2);
      }
      if (ends({ vectors[axis] }))
      {
        this->Vectors[axis] = this->Numbers(fields, 3);
      }
    }
    if (ends({ "xy", "xz", "yz" }))
    {
      this->Tilt = this->Numbers(fields, 3);
    }
    if (ends({ "abc", "origin" }))
    {
      this->Origin = this->Numbers(fields, 3);
    }
  }

  // The numbers that begin a header line of `count` numbers.
  std::vector<double> Numbers(const Fields& fields, std::size_t count, bool areCounts = false) const
  {
    std::vector<double> numbers;
    for (std::size_t i = 0; i < std::min(count, fields.size()); ++i)
    {
      double value;
      const char* const end = fields[i].data() + fields[i].size();
      if (ParseNumber(fields[i].data(), end, value) == end && std::isfinite(value) &&
        (!areCounts || IsCount(value)))
      {
        numbers.push_back(value);
      }
    }
    if (numbers.size() != count)
    {
      this->Lines.Refuse(areCounts ? "the number of atoms" : std::to_string(count) + " numbers");
    }
    return numbers;
  }

  // A box along the axes, tilted or not, or three vectors. The file does not say along which axes
  // it is periodic, so that is as LAMMPS has it by default: along all.
  void SetCell()
  {
    const auto all = [](const std::array<std::vector<double>, 3>& of)
    { return std::none_of(of.begin(), of.end(), [](const auto& one) { return one.empty(); }); };
    SimulationCell cell{};
    if (all(this->Vectors))
    {
      for (int i = 0; i < 3; ++i)
      {
        std::copy_n(this->Vectors[i].begin(), 3, cell.Vectors[i]);
        cell.Origin[i] = this->Origin.empty() ? 0.0 : this->Origin[i];
      }
    }
    else if (all(this->Bounds))
    {
      for (int i = 0; i < 3; ++i)
      {
        cell.Origin[i] = this->Bounds[i][0];
        cell.Vectors[i][i] = this->Bounds[i][1] - this->Bounds[i][0];
      }
      if (!this->Tilt.empty())
      {
        cell.Vectors[1][0] = this->Tilt[0];
        cell.Vectors[2][0] = this->Tilt[1];
        cell.Vectors[2][1] = this->Tilt[2];
      }
    }
    else
    {
      return;
    }
    this->File.Cell = cell;
  }

  LineCursor Lines;
  LammpsDataFile File;
  std::array<std::vector<double>, 3> Bounds;
  std::array<std::vector<double>, 3> Vectors;
  std::vector<double> Tilt;
  std::vector<double> Origin;
};
}

//------------------------------------------------------------------------------
LammpsDataFile ScanLammpsData(const TextRange& text)
{
  return DataScanner(text).Scan();
}

//------------------------------------------------------------------------------
bool BeginsAsLammpsData(const char* begin, const char* end)
{
  LineCursor lines({ begin, end });
  lines.Step();
  while (lines.Step())
  {
    const Fields fields = HeaderFields(lines);
    double value;
    if (fields.size() == 2 && fields[1] == "atoms")
    {
      const char* const last = fields[0].data() + fields[0].size();
      return ParseNumber(fields[0].data(), last, value) == last;
    }
    // Before it there are only other lines of numbers with words after them.
    if (!fields.empty() &&
      (!ParseNumber(fields[0].data(), fields[0].data() + fields[0].size(), value) ||
        fields.back().empty() || !IsLetter(fields.back().front())))
    {
      return false;
    }
  }
  return false;
}
}
