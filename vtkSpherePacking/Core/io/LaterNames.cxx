// SPDX-License-Identifier: BSD-3-Clause
#include "io/LaterNames.h"

#include "io/DiameterWords.h"
#include "io/FitComments.h"
#include "io/NameLists.h"
#include "io/PackingFileError.h"
#include "io/RemarksOnSize.h"
#include "io/TableHead.h"

#include "vtkSMPTools.h"

#include <algorithm>
#include <optional>
#include <string>
#include <string_view>
#include <utility>

namespace spherepacking
{
namespace
{
bool IsOfSphere(const Column& column)
{
  return column.Role <= ColumnRole::Diameter;
}

std::vector<ColumnRole> RolesOfSphere(const std::vector<Column>& columns)
{
  std::vector<ColumnRole> roles;
  for (const Column& column : columns)
  {
    if (IsOfSphere(column))
    {
      roles.push_back(column.Role);
    }
  }
  return roles;
}

// Columns of which none is a size: with radii from elsewhere it does not matter what one is called.
std::vector<Column> WithoutSizes(std::vector<Column> columns)
{
  for (Column& column : columns)
  {
    column.Role = column.Role > ColumnRole::Z ? ColumnRole::Extra : column.Role;
  }
  return columns;
}

// Whether x, y, z and the size are the same columns, or at least in the same order where a comment
// names more or fewer.
bool Agree(std::vector<Column> named, const std::vector<Column>& columns)
{
  named = HasRadius(columns) ? std::move(named) : WithoutSizes(std::move(named));
  if (RolesOfSphere(named) != RolesOfSphere(columns))
  {
    return false;
  }
  if (named.size() != columns.size())
  {
    return IsOfSphere(columns[0]) ? !IsIdName(named[0].Name) : !IsOfSphere(named[0]);
  }
  return std::equal(named.begin(), named.end(), columns.begin(),
    [](const Column& a, const Column& b) { return IsOfSphere(a) == IsOfSphere(b); });
}

bool SameCell(const SimulationCell& a, const std::optional<SimulationCell>& b)
{
  return b && std::equal(&a.Vectors[0][0], &a.Vectors[0][0] + 9, &b->Vectors[0][0]);
}

// Whether the fourth column is a radius by its place alone.
bool MayHoldDiameters(const TableLayout& layout, Radii radii)
{
  return (layout.Named == Naming::None || layout.Named == Naming::FourAfterWords) &&
    radii == Radii::Required;
}

// The one of comments that stand together that names other columns or another cell, if any does.
std::optional<TextRange> FindOther(
  const TableHead& comments, const TableLayout& layout, std::string_view yade, Radii radii)
{
  if (!comments.YadeNames.empty())
  {
    const bool same =
      comments.YadeNames == yade && (!comments.Cell || SameCell(*comments.Cell, layout.Cell));
    return same ? std::nullopt : std::optional(comments.Comments.front());
  }
  const std::vector<Column>& columns = layout.Columns;
  const CommentFit fit = FitComments(comments, columns.size(), radii);
  if (fit.What == NamesFit::Fits)
  {
    return Agree(fit.Columns, columns) ? std::nullopt : std::optional(fit.Line);
  }
  for (const TextRange& comment : comments.Comments)
  {
    if (MayHoldDiameters(layout, radii))
    {
      CheckNoDiameter(comment, columns.size());
    }
    std::string complaint;
    const auto some = ColumnsFromNames(NameWords(View(comment)), complaint);
    if (NamesOtherColumns(View(comment), columns.size()) ||
      (some && complaint.empty() && !Agree(*some, columns)))
    {
      return comment;
    }
  }
  return std::nullopt;
}

bool IsComment(const char* p, const char* end)
{
  p = SkipBlanks(p, end);
  return p != end && *p == '#';
}

// Whether comments may name coordinates, or diameters if `sizes`: most do not, and take no more
// time than this.
bool MayName(std::string_view comments, bool sizes)
{
  const auto has = [&](const char* letters)
  { return comments.find_first_of(letters) != comments.npos; };
  const auto says = [&](std::string_view word) { return comments.find(word) != comments.npos; };
  return (has("xX") && has("yY") && has("zZ")) || says("#format") || says("PERIODIC") ||
    says("ositio") || says("entr") || says("ente") || says("oord") ||
    (sizes && SpeaksOfDiameter(comments));
}

// Comments that stand together in `chunk`, as one range each, if they may name columns or if they
// may go on in another chunk.
std::vector<TextRange> FindComments(const TextChunk& chunk, bool sizes)
{
  std::vector<TextRange> found;
  const auto dropLast = [&]
  {
    if (!found.empty() && found.back().Begin != chunk.Begin && !MayName(View(found.back()), sizes))
    {
      found.pop_back();
    }
  };
  LineFinder find(chunk.End);
  vtkIdType line = chunk.FirstLine;
  bool inside = false;
  for (const char* p = chunk.Begin; p != chunk.End; ++line)
  {
    const char* const end = find(p);
    const bool comment = IsComment(p, end);
    if (comment && !inside)
    {
      found.push_back({ p, end, line });
    }
    else if (comment)
    {
      found.back().End = end;
    }
    else if (inside)
    {
      dropLast();
    }
    inside = comment;
    p = SkipLineEnd(end, chunk.End);
  }
  return found;
}

TableHead ReadComments(const TextRange& text)
{
  TableHead head;
  LineFinder find(text.End);
  vtkIdType line = text.FirstLine;
  for (const char* p = text.Begin; p != text.End; ++line)
  {
    const char* const end = find(p);
    AddComment({ SkipBlanks(p, end), end, line }, head);
    p = SkipLineEnd(end, text.End);
  }
  return head;
}
}

//------------------------------------------------------------------------------
void CheckLaterNames(const TextRange& text, const std::vector<TextChunk>& chunks,
  const TableLayout& layout, Radii radii)
{
  const bool sizes = MayHoldDiameters(layout, radii);
  std::vector<std::vector<TextRange>> found(chunks.size());
  vtkSMPTools::For(0, static_cast<vtkIdType>(chunks.size()), 1,
    [&](vtkIdType first, vtkIdType last)
    {
      for (vtkIdType i = first; i < last; ++i)
      {
        const bool isLast = i + 1 == static_cast<vtkIdType>(chunks.size());
        if (isLast || chunks[i + 1].FirstLine - chunks[i].FirstLine != chunks[i].Rows)
        {
          found[i] = FindComments(chunks[i], sizes);
        }
      }
    });
  std::vector<TextRange> all;
  for (const std::vector<TextRange>& some : found)
  {
    for (const TextRange& comments : some)
    {
      const bool goesOn = !all.empty() && SkipLineEnd(all.back().End, text.End) == comments.Begin;
      goesOn ? void(all.back().End = comments.End) : all.push_back(comments);
    }
  }
  const TextRange row = FindRow(text);
  const std::string_view yade = FindHead(text).YadeNames;
  std::string_view previous;
  for (const TextRange& comments : all)
  {
    if (comments.Begin < row.Begin || View(comments) == previous || !MayName(View(comments), sizes))
    {
      continue;
    }
    previous = View(comments);
    if (const auto other = FindOther(ReadComments(comments), layout, yade, radii))
    {
      throw LineError(other->FirstLine,
        "found the comment " + Quote(other->Begin, other->End) + " after rows of " +
          layout.Expected + ", expected the same columns in all rows");
    }
  }
}
}
