// SPDX-License-Identifier: BSD-3-Clause
#include "io/TableDetector.h"

#include "io/DecimalCommas.h"
#include "io/DiameterWords.h"
#include "io/FitComments.h"
#include "io/GivenColumns.h"
#include "io/NameBrackets.h"
#include "io/NameLists.h"
#include "io/NameMeaning.h"
#include "io/NamelessColumns.h"
#include "io/PackingFileError.h"
#include "io/RemarksOnOrder.h"
#include "io/RemarksOnSize.h"
#include "io/SizeComponents.h"
#include "io/TableHead.h"
#include "io/UnitsBesideNames.h"
#include "io/UnitsOfRemark.h"
#include "io/UnnamedIndex.h"
#include "io/UsualForms.h"

#include <algorithm>
#include <set>
#include <string>
#include <string_view>
#include <vector>

namespace spherepacking
{
namespace
{
using Fields = std::vector<std::string_view>;

std::string QuoteLine(const TextRange& line)
{
  return Quote(SkipBlanks(line.Begin, line.End), line.End);
}

// The first of `delimiters` that stands in `line`, or 0.
char FindDelimiter(const TextRange& line, std::string_view delimiters)
{
  for (const char delimiter : delimiters)
  {
    if (std::find(line.Begin, line.End, delimiter) != line.End)
    {
      return delimiter;
    }
  }
  return 0;
}

/// Finds the columns of one table.
class Detector
{
public:
  Detector(Format format, const ReadOptions& options, TextRange& text)
    : FormatIs(format)
    , RadiiAre(options.RadiusOptional ? Radii::Optional : Radii::Required)
    , IsFourthRadius(options.IsFourthRadius)
    , Head(FindHead(text))
    , Text(text)
  {
  }

  TableLayout Detect()
  {
    this->SkipSeparatorLine();
    if (this->FormatIs == Format::Csv)
    {
      this->DetectCsv();
    }
    else
    {
      this->DetectPlain();
    }
    this->CheckUnits();
    this->Layout.Expected = DescribeColumns(this->Layout.Columns);
    return this->Layout;
  }

private:
  void DetectCsv()
  {
    if (const char delimiter = FindDelimiter(this->Head.Row, ";\t,"))
    {
      this->Layout.Between = Separators::Strict(delimiter);
    }
    const Fields fields = this->Layout.Between.Split(this->Head.Row.Begin);
    const bool numbers = !fields.empty() && std::all_of(fields.begin(), fields.end(), IsNumber);
    if (!numbers || !this->TakeComments(fields.size()))
    {
      this->SkipHeader();
      this->SkipUnits();
      const TextRange row = FindRow(this->Text);
      const std::size_t count = row.Begin ? this->Layout.Between.Split(row.Begin).size() : 0;
      if (!this->TakeIndexedHeader(count))
      {
        this->TakeStrictHeader();
      }
      MarkTextColumns(this->Layout, FindHead(this->Text).Row.Begin);
    }
  }

  void DetectPlain()
  {
    const TextRange& row = this->Head.Row;
    const Fields fields = this->Layout.Between.Split(row.Begin);
    if (this->IsHeader(fields))
    {
      this->SkipHeader();
      this->SkipUnits();
      this->TakePlainHeader();
      return;
    }
    if (HasDecimalCommas(View(row)))
    {
      throw LineError(row.FirstLine,
        "found what looks like decimal commas in " + QuoteLine(row) + ", expected decimal points");
    }
    if (!this->TakeYadeFormat(fields.size()) && !this->TakeComments(fields.size()))
    {
      this->CheckProse();
      this->CheckPlainRemarks(fields.size());
      const bool fourth = this->IsFourthRadius && fields.size() > 3;
      this->Layout.Columns =
        NamelessColumns(this->FormatIs, this->Text, row, fourth ? Radii::Required : this->RadiiAre);
    }
    MarkTextColumns(this->Layout, row.Begin);
    this->Layout.Cell = this->Head.Cell;
    this->Layout.Ends = this->FormatIs == Format::Xyzr ? LineEnds::ByProgram : this->Head.Ends;
  }

  // Excel's first line "sep=;" says what separates fields, which the header shows, too.
  void SkipSeparatorLine()
  {
    const std::string_view row = View(this->Head.Row);
    if (row.size() == 5 && row.substr(0, 4) == "sep=")
    {
      this->SkipHeader();
      this->Head = FindHead(this->Text);
    }
  }

  void SkipHeader()
  {
    const TextRange& row = this->Head.Row;
    const char* line = row.Begin;
    while (line != this->Text.Begin && IsBlank(line[-1]))
    {
      --line;
    }
    this->Indent = row.Begin - line;
    this->Text = { SkipLineEnd(row.End, this->Text.End), this->Text.End, row.FirstLine + 1 };
  }

  // Skips a line of units under a header. No row can look so.
  void SkipUnits()
  {
    const TextRange row = FindRow(this->Text);
    if (row.Begin)
    {
      this->Units = this->Layout.Between.Split(row.Begin);
      if (AreUnits(this->Units))
      {
        this->UnitsLine = row;
        this->Text = { SkipLineEnd(row.End, this->Text.End), this->Text.End, row.FirstLine + 1 };
      }
    }
  }

  // Throws if units beside names are those of different lengths.
  void CheckUnits() const
  {
    if (this->UnitsLine.Begin)
    {
      CheckUnitsOfColumns(this->UnitsLine, this->Units, this->Layout.Columns);
    }
    if (this->Layout.Named == Naming::All)
    {
      CheckUnitsOfRemarks(this->Head.Comments, this->Layout.Columns);
    }
  }

  // Whether the first row names coordinates, by itself or over as many columns as the next row has.
  bool IsHeader(const Fields& fields) const
  {
    const std::string_view line = View(this->Head.Row);
    std::string complaint;
    if (ColumnsFromNames(fields, complaint, Radii::Optional) ||
      ColumnsFromNames(NameWords(line), complaint, Radii::Optional))
    {
      return true;
    }
    if (std::any_of(fields.begin(), fields.end(), IsNumber))
    {
      return false;
    }
    const TextRange next =
      FindRow({ SkipLineEnd(this->Head.Row.End, this->Text.End), this->Text.End });
    return next.Begin &&
      FitNames(line, this->Layout.Between.Split(next.Begin).size(), Radii::Optional).What ==
      NamesFit::Fits;
  }

  // A header whose names are the fields between delimiters.
  void TakeStrictHeader()
  {
    const TextRange& line = this->Head.Row;
    Fields names = WithoutNumbers(this->Layout.Between.Split(line.Begin));
    // The first of three, or the number of names for none: of a std::optional GCC 12 thinks here
    // that it may be read without a value.
    const std::size_t none = names.size();
    const std::size_t components =
      this->RadiiAre == Radii::Required ? FindSizeComponents(names).value_or(none) : none;
    if (components < none)
    {
      CheckSizeComponents(this->Text, this->Layout.Between, components);
      names[components].remove_suffix(2);
    }
    std::string complaint;
    const auto columns = ColumnsFromNames(names, complaint, this->RadiiAre);
    if (!columns)
    {
      throw LineError(line.FirstLine,
        "found the columns " + Quote(line.Begin, line.End) +
          ", expected a header that names x, y, z and one of r, radius, d, diameter, # before "
          "titles above it, or " +
          HintFor(names.size()));
    }
    if (!complaint.empty())
    {
      throw LineError(line.FirstLine, complaint + ", or " + HintFor(names.size()));
    }
    this->Layout.Columns = *columns;
    for (std::size_t i = 1; components < none && i < 3; ++i)
    {
      this->Layout.Columns[components + i].Role = ColumnRole::Skipped;
    }
  }

  // A header of one name fewer than the `count` columns, of which the first must be an index:
  // pandas' to_string and R's write.table give it no name. False if there are not so many names.
  bool TakeIndexedHeader(std::size_t count)
  {
    const TextRange& header = this->Head.Row;
    const Separators& between = this->Layout.Between;
    NamesFit fit;
    if (!between.IsStrict())
    {
      fit = FitNames(View(header), count - 1, this->RadiiAre);
    }
    else if (const Fields names = between.Split(header.Begin); names.size() + 1 == count)
    {
      auto columns = ColumnsFromNames(names, fit.Complaint, this->RadiiAre);
      fit.What = columns && fit.Complaint.empty() ? NamesFit::Fits : NamesFit::NoNames;
      fit.Columns = columns ? std::move(*columns) : std::vector<Column>();
    }
    if (fit.What != NamesFit::Fits)
    {
      return false;
    }
    const UnnamedIndex index = FindIndex(this->Text, between, this->Indent);
    if (index != UnnamedIndex::Certain)
    {
      throw LineError(header.FirstLine,
        "found the " + std::to_string(count - 1) + " names " + QuoteLine(header) +
          " over rows of " + std::to_string(count) + " columns" +
          (index == UnnamedIndex::Possible ? ", of which the first may be an index without a name"
                                           : "") +
          ", expected a name for each column, or " + HintFor(count));
    }
    fit.Columns.insert(fit.Columns.begin(), Column{ ColumnRole::Skipped, "-" });
    this->Layout.Columns = std::move(fit.Columns);
    return true;
  }

  // A header with delimiters is that of a CSV file by another name. In others blanks may be part
  // of names, and the first row tells how many there are.
  void TakePlainHeader()
  {
    const TextRange& header = this->Head.Row;
    const TextRange row = FindHead(this->Text).Row;
    if (const char delimiter = FindDelimiter(header, ";,"))
    {
      this->Layout.Between = Separators::Strict(delimiter);
    }
    const std::size_t count = this->Layout.Between.Split(row.Begin).size();
    NamesFit fit =
      this->Layout.Between.IsStrict() ? NamesFit() : FitNames(View(header), count, this->RadiiAre);
    if (fit.What == NamesFit::Fits)
    {
      this->Layout.Columns = std::move(fit.Columns);
    }
    else if (!fit.Complaint.empty())
    {
      throw LineError(header.FirstLine, fit.Complaint + ", or " + HintFor(count));
    }
    else if (!this->TakeIndexedHeader(count))
    {
      // With tabs between, names and text may have blanks in them.
      const Separators tabs = Separators::Strict('\t');
      const Fields names = tabs.Split(header.Begin);
      const bool tabbed = names.size() > 3 && names.size() == tabs.Split(row.Begin).size() &&
        std::none_of(names.begin(), names.end(), [](auto name) { return name.empty(); });
      this->Layout.Between = tabbed ? tabs : this->Layout.Between;
      if (fit.What == NamesFit::Unclear && !tabbed &&
        this->Layout.Between.Split(header.Begin).size() == count)
      {
        this->ThrowUnclear(header, count);
      }
      this->TakeStrictHeader();
    }
    MarkTextColumns(this->Layout, row.Begin);
  }

  // #format x_y_z_r_attrs names all but the columns that attrs stands for, of which there may be
  // none. A comment can only give these their names.
  bool TakeYadeFormat(std::size_t count)
  {
    if (this->Head.YadeNames.empty())
    {
      return false;
    }
    Fields names;
    for (std::string_view rest = this->Head.YadeNames; !rest.empty();)
    {
      const std::size_t cut = std::min(rest.find('_'), rest.size());
      names.push_back(rest.substr(0, cut));
      rest.remove_prefix(std::min(cut + 1, rest.size()));
    }
    const bool attributes = !names.empty() && names.back() == "attrs";
    names.resize(names.size() - (attributes ? 1 : 0));
    const std::size_t named = names.size();
    std::string complaint;
    auto columns = ColumnsFromNames(names, complaint, this->RadiiAre);
    if (!columns || !complaint.empty())
    {
      throw LineError(this->Head.Row.FirstLine,
        "found rows under #format " +
          Quote(this->Head.YadeNames.data(),
            this->Head.YadeNames.data() + this->Head.YadeNames.size()) +
          ", expected a format such as x_y_z_r or x_y_z_r_matId");
    }
    const auto comment = FitComments(this->Head, count, this->RadiiAre);
    const bool agrees = comment.What == NamesFit::Fits &&
      std::equal(columns->begin(), columns->end(), comment.Columns.begin(),
        comment.Columns.begin() + std::min(named, count),
        [](const Column& a, const Column& b) { return a.Role == b.Role; });
    for (std::size_t i = named; attributes && i < count; ++i)
    {
      const std::string name = "attrs_" + std::to_string(i + 1 - named);
      columns->push_back({ ColumnRole::Extra, agrees ? comment.Columns[i].Name : name });
    }
    this->Layout.Columns = std::move(*columns);
    return true;
  }

  // The columns that comments name. False if they name none, or if the first four are x, y, z and
  // radius by name or by place.
  bool TakeComments(std::size_t count)
  {
    CommentFit fit = FitComments(this->Head, count, this->RadiiAre);
    if (fit.What == NamesFit::Fits)
    {
      this->Layout.Columns = std::move(fit.Columns);
      return true;
    }
    for (const TextRange& comment : this->Head.Comments)
    {
      if (NamesOtherColumns(View(comment), count))
      {
        this->ThrowNames(
          comment.FirstLine == fit.Line.FirstLine ? fit.Complaint : "", comment, count);
      }
    }
    if (fit.What == NamesFit::NoNames)
    {
      this->Layout.Named = Naming::None;
      return false;
    }
    if (!fit.OneEach && !HasTwoUnits(View(fit.Line)) && FindUnclearBracket(View(fit.Line)).empty())
    {
      this->Layout.Named = this->FirstFour(View(fit.Line), count);
      const auto forms = UsualForms(View(fit.Line), count);
      for (std::size_t i = 0; i < forms.size() && this->Layout.Named == Naming::All; ++i)
      {
        this->Layout.Named = this->FirstFour(forms[i], count);
      }
    }
    if (this->Layout.Named != Naming::All)
    {
      return false;
    }
    this->ThrowNames(fit.Complaint, fit.Line, count);
  }

  [[noreturn]] void ThrowNames(
    const std::string& complaint, const TextRange& line, std::size_t count) const
  {
    if (!complaint.empty())
    {
      throw LineError(line.FirstLine, complaint + ", or " + HintFor(count));
    }
    this->ThrowUnclear(line, count);
  }

  [[noreturn]] void ThrowUnclear(const TextRange& line, std::size_t count) const
  {
    throw LineError(line.FirstLine,
      "found the names " + QuoteLine(line) + " over rows of " + std::to_string(count) +
        " columns, expected a name for each column, or " + HintFor(count));
  }

  // What a comment that does not name all columns, and only them, says of the first four, or All if
  // that is not certain. With words before or between x, y, z and radius, or without the radius,
  // the rows must have four columns.
  static Naming FirstFour(std::string_view line, std::size_t count)
  {
    const Fields words = NameWords(line);
    std::string complaint;
    const auto columns = ColumnsFromNames(words, complaint, Radii::Optional);
    const auto roles = columns ? *columns : std::vector<Column>();
    std::vector<std::size_t> sphere; // where its words are
    for (std::size_t i = 0; i < roles.size(); ++i)
    {
      if (roles[i].Role <= ColumnRole::Diameter)
      {
        sphere.push_back(i);
      }
    }
    for (std::size_t i = 0; i < sphere.size(); ++i)
    {
      if (roles[sphere[i]].Role != static_cast<ColumnRole>(i))
      {
        return Naming::All;
      }
    }
    std::set<std::string> lengths;
    for (const std::string_view word : words)
    {
      lengths.insert(LengthUnit(word));
      lengths.insert(MeaningOfName(word).Unit);
    }
    lengths.erase("");
    const bool noRadius = sphere.size() == 3 &&
      (sphere.size() == words.size() || ColumnsFromNames(words, complaint)); // r may be red
    const bool atOnce = sphere.size() == 4 && sphere[3] == 3;
    if (AreNumbered(line) || sphere.size() < 3 || noRadius || lengths.size() > 1 ||
      SpeaksOfDiameter(line) || SpeaksOfOtherSize(line))
    {
      return Naming::All;
    }
    if (atOnce || (count == 4 && sphere[0] == 0))
    {
      return Naming::FirstFour;
    }
    return count == 4 && !IsIdName(roles[sphere[0] - 1].Name) ? Naming::FourAfterWords
                                                              : Naming::All;
  }

  // Throws if remarks before the rows or in the first say that columns are in another order, or
  // that the fourth is no radius.
  void CheckPlainRemarks(std::size_t count) const
  {
    if (this->Layout.Named == Naming::FirstFour)
    {
      return;
    }
    for (const TextRange& remark : this->Head.Comments)
    {
      CheckOrder(remark, count);
    }
    if (this->RadiiAre == Radii::Optional)
    {
      return;
    }
    CheckRemarks(this->Head.Comments, count);
    const TextRange& row = this->Head.Row;
    if (const char* const remark = std::find(row.Begin, row.End, '#'); remark != row.End)
    {
      CheckNoDiameter({ remark, row.End, row.FirstLine }, count);
    }
  }

  // C 1.5 2.5 3.5 may be an element and a place.
  std::string HintForText(const Fields& fields) const
  {
    const bool numbers = fields.size() > 3 && fields.size() < 6 &&
      std::all_of(fields.begin() + 1, fields.end(), IsNumber);
    if (!numbers)
    {
      return ColumnsHint;
    }
    const bool radii = fields.size() == 5;
    return std::string("columns=\"element x y z") + (radii ? " r" : "") + "\" (--columns)" +
      (radii || this->RadiiAre == Radii::Optional ? "" : " and radius= (--radius)") +
      " if the first is an element or the like";
  }

  // Throws if the first row is a sentence.
  void CheckProse() const
  {
    const TextRange& row = this->Head.Row;
    const Fields fields = this->Layout.Between.Split(row.Begin);
    const char c = *row.Begin;
    const bool letter = (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || c < 0;
    const bool number = std::any_of(fields.begin(), fields.end(), IsNumber);
    const bool first = !fields.empty() && IsNumber(fields[0]); // such as nan
    if (letter && !first && (!number || this->FormatIs != Format::Xyzr))
    {
      throw LineError(row.FirstLine,
        "found " + QuoteLine(row) +
          ", which is neither a row of numbers nor a header, expected lines of x y z radius, and # "
          "before remarks; or a header of names, or " +
          this->HintForText(fields));
    }
  }

  Format FormatIs;
  Radii RadiiAre;
  bool IsFourthRadius;
  TableHead Head;
  TextRange& Text;
  std::size_t Indent = 0; // of a header that is no comment
  Fields Units;           // in the line under the header
  TextRange UnitsLine{ nullptr, nullptr, 0 };
  TableLayout Layout;
};
}

//------------------------------------------------------------------------------
TableLayout DetectTable(Format format, const ReadOptions& options, TextRange& text)
{
  return options.Columns.empty() ? Detector(format, options, text).Detect()
                                 : LayoutOfColumns(format, options, text);
}
}
