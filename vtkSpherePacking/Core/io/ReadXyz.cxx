// SPDX-License-Identifier: BSD-3-Clause
#include "io/GivenColumns.h"
#include "io/LineCursor.h"
#include "io/NameMeaning.h"
#include "io/PackingFileError.h"
#include "io/PackingFormats.h"
#include "io/StepRows.h"
#include "io/TextTable.h"
#include "io/TimeSteps.h"
#include "io/XyzComment.h"

#include <algorithm>
#include <set>

namespace spherepacking
{
namespace
{
constexpr const char* Wanted = "Properties such as species:S:1:pos:R:3:radius:R:1";

/// A frame's lines before its atoms.
struct FrameHead
{
  vtkIdType Count;
  vtkIdType CountLine;
  LineCursor Lines; ///< at the comment
};

// Whether a text that begins with a frame has all that its layout depends on, to the first atom.
bool HasHead(const TextRange& text)
{
  LineCursor lines(text);
  int count = 0;
  while (count < 3 && lines.Step())
  {
    count += count > 0 || !lines.Fields().empty();
  }
  return count == 3;
}

FrameHead ReadHead(const TextRange& text)
{
  LineCursor lines(text);
  do
  {
    lines.StepInto("the file", "the number of atoms");
  } while (lines.Fields().empty());
  const vtkIdType count = lines.Count("the number of atoms");
  const vtkIdType countLine = lines.Number();
  lines.StepInto("the file", "a comment");
  return { count, countLine, lines };
}

// The fields of the first atom; none if there is no atom.
std::vector<std::string_view> FirstRow(const TextRange& rows)
{
  LineCursor lines(rows);
  while (lines.Step())
  {
    if (const auto fields = lines.Fields(); !fields.empty())
    {
      return fields;
    }
  }
  return {};
}

std::vector<std::string> SplitAtColons(const std::string& text)
{
  std::vector<std::string> parts(1);
  for (const char c : text)
  {
    if (c == ':')
    {
      parts.emplace_back();
    }
    else
    {
      parts.back() += c;
    }
  }
  return parts;
}

/// Makes columns of the value of Properties.
class PropertyColumns
{
public:
  /// `limit` is the largest number of columns, that of a row.
  PropertyColumns(const std::string& properties, std::size_t limit)
    : Properties(properties)
  {
    const std::vector<std::string> parts = SplitAtColons(properties);
    for (std::size_t i = 0; i + 2 < parts.size(); i += 3)
    {
      const auto count = XyzCount(parts[i + 2]);
      if (!count || *count < 1 || parts[i + 1].size() != 1 ||
        std::string_view("SRIL").find(parts[i + 1]) == std::string_view::npos)
      {
        this->Refuse();
      }
      if (this->Columns.size() + *count > limit)
      {
        throw ContentError("found more columns in Properties=" + this->Quoted() + " than the " +
          std::to_string(limit) + " of the first atom, expected as many");
      }
      this->Add(parts[i], parts[i + 1].front(), static_cast<int>(*count));
    }
    if (parts.size() % 3 != 0 || this->Columns.empty())
    {
      this->Refuse();
    }
  }

  std::vector<Column> Take()
  {
    const auto has = [&](ColumnRole role)
    {
      return std::any_of(this->Columns.begin(), this->Columns.end(),
        [role](const Column& column) { return column.Role == role; });
    };
    if (!has(ColumnRole::X))
    {
      throw ContentError(
        "found no positions in Properties=" + this->Quoted() + ", expected " + Wanted);
    }
    if (!has(ColumnRole::Radius) && !has(ColumnRole::Diameter))
    {
      this->FindOtherSize();
    }
    if (has(ColumnRole::Radius))
    {
      for (Column& column : this->Columns)
      {
        column.Role = column.Role == ColumnRole::Diameter ? ColumnRole::Extra : column.Role;
      }
    }
    return std::move(this->Columns);
  }

  /// The name of a radius or diameter of three components, if that is what there is; call it after
  /// Take().
  const std::string& SizeOfThree() const { return this->Three; }

private:
  /// A property of real or whole numbers.
  struct Property
  {
    std::string Name;
    std::size_t First;
    int Count;
    NameMeaning Meaning;
  };

  // A radius or diameter by another name than the usual ones: r, d, particle_radius, or one of
  // three components, as glyphs have it.
  void FindOtherSize()
  {
    const auto any = [&](auto&& which)
    { return std::any_of(this->Numeric.begin(), this->Numeric.end(), which); };
    const auto means = [&](NameMeaning::Kind kind)
    { return any([kind](const Property& p) { return p.Count == 1 && p.Meaning.What == kind; }); };
    const bool otherR = means(NameMeaning::PolarAngle) || means(NameMeaning::Azimuth) ||
      (means(NameMeaning::Green) && means(NameMeaning::Blue));
    const auto isSize = [&](const Property& p, NameMeaning::Kind kind)
    {
      return p.Meaning.What == kind && p.Meaning.Unit.empty() &&
        (p.Count == 1 || (p.Count == 3 && p.Meaning.IsFullWord)) && !(p.Meaning.IsLetter && otherR);
    };
    for (const auto kind : { NameMeaning::Radius, NameMeaning::Diameter })
    {
      const Property* found = nullptr;
      for (const Property& property : this->Numeric)
      {
        if (!isSize(property, kind))
        {
          continue;
        }
        if (found)
        {
          throw ContentError("found " + found->Name + " and " + property.Name +
            " in Properties=" + this->Quoted() + ", either of which may be the size, expected one");
        }
        found = &property;
      }
      if (found)
      {
        this->Columns[found->First].Role =
          kind == NameMeaning::Radius ? ColumnRole::Radius : ColumnRole::Diameter;
        this->Three = found->Count == 3 ? found->Name : "";
        return;
      }
    }
  }

  std::string Quoted() const
  {
    return Quote(this->Properties.data(), this->Properties.data() + this->Properties.size());
  }

  [[noreturn]] void Refuse() const
  {
    throw ContentError("found Properties=" + this->Quoted() +
      ", expected NAME:TYPE:COLUMNS of each, with the types S, R, I or L");
  }

  static ColumnRole RoleOf(const std::string& name, char type, int count)
  {
    if (type == 'S' || type == 'L')
    {
      return ColumnRole::Text;
    }
    const auto is = [&](const char* singular, const char* plural)
    { return name == singular || name == plural; };
    return count == 3 && (is("pos", "Position") || is("position", "positions")) ? ColumnRole::X
      : count == 1 && (is("radius", "radii") || is("Radius", "Radii"))          ? ColumnRole::Radius
      : count == 1 && (is("diameter", "diameters") || is("Diameter", "Diameters"))
      ? ColumnRole::Diameter
      : ColumnRole::Extra;
  }

  // Components of a vector become NAME_0, NAME_1 and so on, which the packing joins.
  void Add(const std::string& name, char type, int count)
  {
    if (name.empty() || !this->Seen.insert(name).second)
    {
      this->Refuse();
    }
    const ColumnRole role = RoleOf(name, type, count);
    if (role == ColumnRole::Extra)
    {
      this->Numeric.push_back({ name, this->Columns.size(), count, MeaningOfName(name) });
    }
    for (int i = 0; i < count; ++i)
    {
      const bool isCenter = role == ColumnRole::X;
      this->Columns.push_back({ isCenter ? static_cast<ColumnRole>(i) : role,
        isCenter       ? std::string(1, static_cast<char>('x' + i))
          : count == 1 ? name
                       : name + '_' + std::to_string(i) });
    }
  }

  const std::string& Properties;
  std::vector<Column> Columns;
  std::vector<Property> Numeric;
  std::string Three;
  std::set<std::string> Seen;
};

// Makes three components one radius: throws unless they are equal.
void JoinComponents(PackingArrays& arrays, const std::string& name, bool areDiameters)
{
  for (const char* const end : { "_1", "_2" })
  {
    const double* const other = arrays.FindExtra(name + end);
    const double half = areDiameters ? 0.5 : 1.0;
    for (vtkIdType i = 0; i < arrays.GetCount(); ++i)
    {
      const bool equal = other && arrays.IsSingle()
        ? arrays.Radii<float>()[i] == static_cast<float>(half * other[i])
        : other && arrays.Radii<double>()[i] == half * other[i];
      if (!equal)
      {
        throw ContentError("found different components of '" + name + "' of atom " +
          std::to_string(i + 1) + ", expected three that are equal, or one");
      }
    }
    arrays.RemoveExtra(name + end);
  }
  arrays.SetRadiusName(name);
}

// Plain XYZ: a species, x, y, z, and what nobody names.
std::vector<Column> PlainColumns(const std::vector<std::string_view>& row)
{
  std::vector<Column> columns{ { ColumnRole::Extra, "species" }, { ColumnRole::X, "x" },
    { ColumnRole::Y, "y" }, { ColumnRole::Z, "z" } };
  for (std::size_t i = columns.size(); i < row.size(); ++i)
  {
    columns.push_back({ ColumnRole::Extra, "column_" + std::to_string(i + 1) });
  }
  return columns;
}

// How to say that rows have radii though nobody names them.
std::string ColumnsHint(const std::vector<std::string_view>& row)
{
  const std::size_t named = !row.empty() && !IsNumber(row[0]) ? 1 : 0;
  return row.size() < 4 + named ? ""
                                : std::string(", or columns=\"") + (named == 1 ? "element " : "") +
      "x y z r\" (--columns) if the columns are these";
}

// Sets `three` to the name of a size of three components.
TableLayout ReadLayout(const FrameHead& head, const ReadOptions& options, std::string& three)
{
  TableLayout layout;
  three.clear();
  layout.Between = Separators::Blanks();
  const TextRange rows = head.Lines.Rest();
  const auto row = FirstRow(rows);
  const auto properties = XyzComment(head.Lines.Line()).Properties();
  if (properties && !options.Columns.empty())
  {
    throw ContentError("found names of columns for atoms whose Properties say what their columns "
                       "are, expected none");
  }
  if (properties)
  {
    constexpr std::size_t withoutAtoms = 1000;
    PropertyColumns columns(*properties, row.empty() ? withoutAtoms : row.size());
    layout.Columns = columns.Take();
    three = columns.SizeOfThree();
  }
  else
  {
    layout.Columns = options.Columns.empty() ? PlainColumns(row) : GivenColumns(options);
    MarkTextByFirstRow(layout, rows);
  }
  layout.Expected = DescribeColumns(layout.Columns);
  if (!HasRadius(layout.Columns) && !options.RadiusOptional)
  {
    throw ContentError(properties ? "found Properties without a radius, " +
          Quote(properties->data(), properties->data() + properties->size()) + ", expected " +
          Wanted
                                  : "found no Properties in " + head.Lines.Quoted() +
          ", so no radius, expected " + Wanted + ColumnsHint(row));
  }
  return layout;
}

PackingArrays ParseXyz(
  LineBlocks& blocks, const TimeStep& step, const ReadOptions& options, Progress& progress)
{
  blocks.Next();
  while (!HasHead(blocks.Text()) && blocks.Grow())
  {
  }
  // People write plain files of one frame, too.
  LineEnds ends = step.Begin > 0 ? LineEnds::ByProgram : LineEnds::ByPeople;
  TableLayout layout;
  std::string three;
  std::optional<SimulationCell> cell;
  const FrameHead head = blocks.AddLines(
    [&]
    {
      if (ends == LineEnds::ByProgram && blocks.IsLast())
      {
        CheckNotCut(blocks.Text());
      }
      const FrameHead found = ReadHead(blocks.Text());
      try
      {
        layout = ReadLayout(found, options, three);
        const XyzComment comment(found.Lines.Line());
        cell = comment.Cell();
        ends = comment.Properties() ? LineEnds::ByProgram : ends;
      }
      catch (const ContentError& error)
      {
        throw LineError(found.Lines.Number(), error.what());
      }
      return found;
    });
  StepRows rows{ head.Lines.Rest().Begin, head.Count, head.CountLine, "atoms" };
  rows.Ends = ends;
  PackingArrays arrays = ReadStepRows(blocks, rows, layout, options, progress);
  if (!three.empty())
  {
    const bool areDiameters = std::any_of(layout.Columns.begin(), layout.Columns.end(),
      [](const Column& column) { return column.Role == ColumnRole::Diameter; });
    try
    {
      JoinComponents(arrays, three, areDiameters);
    }
    catch (const ContentError& error)
    {
      throw LineError(blocks.LinesBefore(step.Begin) + head.CountLine + 1, error.what());
    }
  }
  if (cell)
  {
    arrays.SetCell(*cell);
  }
  if (step.Time)
  {
    arrays.SetTime(*step.Time);
  }
  return arrays;
}
}

//------------------------------------------------------------------------------
PackingArrays ReadXyz(
  const std::string& file, const TimeStep& step, const ReadOptions& options, Progress& progress)
{
  LineBlocks blocks(file, step.Begin, step.End);
  return WithFileName(file, [&] { return ParseXyz(blocks, step, options, progress); });
}
}
