// SPDX-License-Identifier: BSD-3-Clause
#include "io/FixedForms.h"

#include "io/AtomRecord.h"
#include "io/DockCluster.h"
#include "io/LineScanner.h"
#include "io/PdbRecord.h"
#include "io/TableLayout.h"

#include <algorithm>
#include <unordered_set>

namespace spherepacking
{
namespace
{
// The first record of an atom; empty if there is none.
std::string_view FirstAtom(const TextRange& head)
{
  LineScanner scanner(head);
  while (scanner.Next())
  {
    const std::string_view line = scanner.WholeLine();
    if (IsAtomRecord(line.data(), line.data() + line.size()))
    {
      return line;
    }
  }
  return {};
}

bool IsWholeAtom(std::string_view line)
{
  AtomRecord record;
  double x;
  return SplitAtomRecord(line, record) == AtomFault::None &&
    ParseFinite(record.Numbers[AtomRecord::X], x);
}

// Names of records in lower case may be words of prose or the names of columns, so an atom has to
// follow them; those in capitals that begin most files need not.
bool BeginsAsPdb(const TextRange& head)
{
  LineScanner scanner(head);
  scanner.Next();
  for (const std::string_view record : { "ATOM ", "HETATM", "REMARK", "HEADER" })
  {
    if (scanner.Line().substr(0, record.size()) == record)
    {
      return true;
    }
  }
  const auto begins = [&](const char* record)
  { return BeginsWithRecord(scanner.Line().data(), head.End, record); };
  return (begins("ATOM") || begins("HETATM") || begins("REMARK") || begins("HEADER") ||
           begins("TITLE") || begins("CRYST") || begins("MODEL")) &&
    IsWholeAtom(FirstAtom(head));
}

// HOLE names its atoms QSS SPH, or QC1 SPH for the end of a capsule.
bool IsHole(const TextRange& head)
{
  const std::string_view name = PdbColumns(FirstAtom(head), 13, 20);
  return name == "QSS SPH" || name == "QC1 SPH";
}

bool IsDock(const TextRange& head)
{
  LineScanner scanner(head, {});
  while (scanner.Next())
  {
    if (ParseDockCluster(scanner))
    {
      return true;
    }
  }
  return false;
}

bool IsKratos(const TextRange& head)
{
  LineScanner scanner(head, "//");
  const auto fields = scanner.Next() ? scanner.Fields() : std::vector<std::string_view>();
  constexpr std::string_view blocks[] = { "ModelPartData", "Properties", "Nodes", "Table" };
  return fields.size() > 1 && fields[0] == "Begin" &&
    std::find(std::begin(blocks), std::end(blocks), fields[1]) != std::end(blocks);
}

// The whole numbers of the next line; empty if anything else is there.
std::vector<vtkIdType> NextIntegers(LineScanner& scanner)
{
  std::vector<vtkIdType> numbers;
  for (const std::string_view field :
    scanner.Next() ? scanner.Fields() : std::vector<std::string_view>())
  {
    numbers.emplace_back();
    if (!ParseInteger(field, numbers.back()) || numbers.back() < 0)
    {
      return {};
    }
  }
  return numbers;
}

// By the dimension, the numbers of spheres and species, and that of each species.
bool IsPackLsd(const TextRange& head)
{
  LineScanner scanner(head, "!");
  const auto dimension = NextIntegers(scanner);
  const auto counts = NextIntegers(scanner);
  const auto species = NextIntegers(scanner);
  if (dimension.size() != 1 || (dimension[0] != 2 && dimension[0] != 3) || counts.size() != 2 ||
    static_cast<vtkIdType>(species.size()) != counts[1])
  {
    return false;
  }
  double sum = 0.0;
  for (const vtkIdType count : species)
  {
    sum += static_cast<double>(count);
  }
  return sum == static_cast<double>(counts[0]);
}

// By the counts, and a vertex after its letter.
bool IsMedialAxis(const TextRange& head)
{
  LineScanner scanner(head);
  const auto counts = NextIntegers(scanner);
  const auto fields = scanner.Next() ? scanner.Fields() : std::vector<std::string_view>();
  double value;
  return (counts.size() == 2 || counts.size() == 3) && fields.size() >= 5 && fields[0] == "v" &&
    std::all_of(fields.begin() + 1, fields.end(), [&](auto f) { return ParseFinite(f, value); });
}

// By two rows at least, all of seven numbers, of which the last is -1 at first, and then -1 or an
// id in the first column. Most parents come before, but in a long file some may lie beyond the
// head.
bool IsSwc(const TextRange& head)
{
  LineScanner scanner(head);
  std::unordered_set<vtkIdType> ids;
  std::vector<vtkIdType> parents;
  while (scanner.Next())
  {
    const auto fields = scanner.Fields();
    vtkIdType id;
    vtkIdType type;
    vtkIdType parent;
    if (fields.size() != 7 || !ParseInteger(fields[0], id) || !ParseInteger(fields[1], type) ||
      !ParseInteger(fields[6], parent) || id < 0 || parent < -1 ||
      (parents.empty() && parent != -1))
    {
      return false;
    }
    ids.insert(id);
    parents.push_back(parent);
  }
  const auto known = std::count_if(parents.begin(), parents.end(),
    [&](vtkIdType parent) { return parent == -1 || ids.count(parent) > 0; });
  return parents.size() >= 2 && 10 * known >= 9 * static_cast<std::ptrdiff_t>(parents.size());
}

bool NamesColumns(const TextRange& head)
{
  LineFinder find(head.End);
  for (const char* p = head.Begin; p != head.End; p = SkipLineEnd(find(p), head.End))
  {
    const char* first = SkipBlanks(p, head.End);
    std::string complaint;
    if (*first == '#' && ColumnsFromNames(Separators::Liberal().Split(first + 1), complaint))
    {
      return true;
    }
  }
  return false;
}
}

//------------------------------------------------------------------------------
Format GuessFixedForm(const TextRange& head)
{
  LineScanner scanner(head);
  if (!scanner.Next())
  {
    return Format::Auto;
  }
  if (IsDock(head))
  {
    return Format::Dock;
  }
  if (BeginsAsPdb(head))
  {
    return IsHole(head) ? Format::Hole : Format::Pqr;
  }
  if (scanner.Fields()[0] == "LSMGeometry")
  {
    return Format::GenGeo;
  }
  return IsKratos(head)                  ? Format::Kratos
    : IsPackLsd(head)                    ? Format::PackLsd
    : IsMedialAxis(head)                 ? Format::MedialAxis
    : IsSwc(head) && !NamesColumns(head) ? Format::Swc
                                         : Format::Auto;
}
}
