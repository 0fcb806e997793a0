// SPDX-License-Identifier: BSD-3-Clause
#include "io/AtomRecord.h"

#include "io/Number.h"
#include "io/PdbRecord.h"

#include <algorithm>
#include <array>

namespace spherepacking
{
namespace
{
// Takes the first field, which ends at a blank, off `text`.
std::string_view TakeField(std::string_view& text)
{
  while (!text.empty() && IsBlank(text.front()))
  {
    text.remove_prefix(1);
  }
  std::size_t length = 0;
  while (length < text.size() && !IsBlank(text[length]))
  {
    ++length;
  }
  const std::string_view field = text.substr(0, length);
  text.remove_prefix(length);
  return field;
}

// The same with the last field.
std::string_view TakeLastField(std::string_view& text)
{
  while (!text.empty() && IsBlank(text.back()))
  {
    text.remove_suffix(1);
  }
  std::size_t first = text.size();
  while (first > 0 && !IsBlank(text[first - 1]))
  {
    --first;
  }
  const std::string_view field = text.substr(first);
  text.remove_suffix(field.size());
  return field;
}

// A letter or two, and perhaps a formal charge such as 1+. No number looks so.
bool IsElement(std::string_view field)
{
  std::size_t letters = 0;
  while (letters < field.size() && IsLetter(field[letters]))
  {
    ++letters;
  }
  return letters >= 1 && letters <= 2 && field.size() <= letters + 2;
}

bool HasDigit(std::string_view field)
{
  return field.find_first_of("0123456789") != field.npos;
}

// Whether `field` begins with a whole number; sets `number` and what follows it.
bool SplitResidueNumber(
  std::string_view field, std::string_view& number, std::string_view& insertionCode)
{
  std::size_t end = !field.empty() && field.front() == '-' ? 1 : 0;
  const std::size_t first = end;
  while (end < field.size() && IsDigit(field[end]))
  {
    ++end;
  }
  if (end == first || field.size() > end + 1 || (field.size() == end + 1 && !IsLetter(field[end])))
  {
    return false;
  }
  number = field.substr(0, end);
  insertionCode = field.substr(end);
  return true;
}

// The fields before the coordinates.
struct Leading
{
  std::array<std::string_view, 5> Fields; ///< those after the serial number
  std::size_t Count = 0;                  ///< how many there are, perhaps more than are kept
  std::string_view Last;
};

Leading SplitLeading(std::string_view text)
{
  Leading leading;
  // A serial number of five digits touches HETATM.
  if (!HasDigit(TakeField(text)))
  {
    leading.Last = TakeField(text);
  }
  for (std::string_view field = TakeField(text); !field.empty(); field = TakeField(text))
  {
    if (leading.Count < leading.Fields.size())
    {
      leading.Fields[leading.Count] = field;
    }
    leading.Last = field;
    ++leading.Count;
  }
  return leading;
}

// Name, residue, chain and number of the residue by the blanks between them; false if these fields
// are anything else.
bool NameByFields(const Leading& leading, AtomRecord& record)
{
  const auto& fields = leading.Fields;
  if (leading.Count < 3 || leading.Count > fields.size())
  {
    return false;
  }
  record.Name = fields[0];
  record.Residue = fields[1];
  const auto number = [&](std::string_view field)
  { return SplitResidueNumber(field, record.ResidueNumber, record.InsertionCode); };
  if (leading.Count == 3)
  {
    // A residue number of four digits touches its chain.
    if (!number(fields[2]) && number(fields[2].substr(1)))
    {
      record.Chain = fields[2].substr(0, 1);
    }
    return !record.ResidueNumber.empty();
  }
  const bool code = fields[leading.Count - 1].size() == 1 && !HasDigit(leading.Last);
  const std::size_t at = leading.Count - (code ? 2 : 1);
  if (at > 3 || !number(fields[at]))
  {
    return false;
  }
  if (code)
  {
    record.InsertionCode = leading.Last;
  }
  if (at == 3)
  {
    record.Chain = fields[2];
  }
  return true;
}

void NameByColumns(std::string_view line, AtomRecord& record)
{
  record.Name = PdbColumns(line, 13, 16);
  record.Residue = PdbColumns(line, 17, 20);
  record.Chain = PdbColumns(line, 22, 22);
  record.ResidueNumber = record.InsertionCode = {};
  std::string_view none;
  SplitResidueNumber(PdbColumns(line, 23, 26), record.ResidueNumber, none);
  record.InsertionCode = PdbColumns(line, 27, 27);
}

// Charge, radius and perhaps an element, and nothing else.
bool SplitTail(std::string_view tail, AtomRecord& record)
{
  record.Numbers[AtomRecord::Charge] = TakeField(tail);
  record.Numbers[AtomRecord::Radius] = TakeField(tail);
  record.Element = TakeField(tail);
  return !record.Numbers[AtomRecord::Radius].empty() &&
    !IsElement(record.Numbers[AtomRecord::Radius]) &&
    (record.Element.empty() || IsElement(record.Element)) && TakeField(tail).empty();
}
}

//------------------------------------------------------------------------------
AtomFault SplitAtomRecord(std::string_view line, AtomRecord& record)
{
  record = {};
  const bool inColumns = HoldsCoordinates(line);
  if (inColumns && SplitTail(line.substr(54), record))
  {
    for (std::size_t axis = 0; axis < 3; ++axis)
    {
      record.Numbers[axis] = PdbColumns(line, 31 + 8 * axis, 38 + 8 * axis);
    }
    if (!NameByFields(SplitLeading(line.substr(0, 30)), record))
    {
      NameByColumns(line, record);
    }
    return AtomFault::None;
  }

  record = {};
  std::string_view rest = line;
  std::string_view last = TakeLastField(rest);
  if (IsElement(last))
  {
    record.Element = last;
    last = TakeLastField(rest);
  }
  for (int i = AtomRecord::Radius; i >= AtomRecord::X; --i)
  {
    record.Numbers[i] = last;
    last = i > AtomRecord::X ? TakeLastField(rest) : last;
  }
  const Leading leading = SplitLeading(rest);
  // With three, the last is the number of the residue, and not the letter of a chain: else a number
  // is missing, and that of the residue would pass as x.
  if (leading.Count < 3 || (leading.Count == 3 && !HasDigit(leading.Last)))
  {
    return AtomFault::WrongFields;
  }
  // Nor is it a number with decimals: else one is too many, and the last five are others.
  if (!NameByFields(leading, record) &&
    (leading.Count > leading.Fields.size() || leading.Last.find('.') != leading.Last.npos))
  {
    return AtomFault::WrongFields;
  }
  if (inColumns && record.Numbers[AtomRecord::X].data() != PdbColumns(line, 31, 38).data())
  {
    return AtomFault::TwoReadings;
  }
  return AtomFault::None;
}

//------------------------------------------------------------------------------
bool LooksLikeDamagedAtom(std::string_view line)
{
  // The letters of all names of records but ATOM and HETATM; some are followed by a digit.
  constexpr const char* others[] = { "ANISOU", "AUTHOR", "CAVEAT", "CISPEP", "COMPND", "CONECT",
    "CRYST", "DBREF", "EXPDTA", "FORMUL", "HEADER", "HELIX", "HETNAM", "HETSYN", "HYDBND", "JRNL",
    "KEYWDS", "LINK", "LINKR", "MASTER", "MDLTYP", "MODRES", "MTRIX", "NUMMDL", "OBSLTE", "ORIGX",
    "REMARK", "REVDAT", "SCALE", "SEQADV", "SEQRES", "SHEET", "SIGATM", "SIGUIJ", "SITE", "SLTBRG",
    "SOURCE", "SPLIT", "SPRSDE", "SSBOND", "TITLE", "TURN", "TVECT", "USER" };
  // HET, TER, END, ENDMDL and MODEL are not among them: they hold few numbers, while HETATM with a
  // blank in it holds many, and so do those that have lost their line end before an atom.
  const char* const begin = line.data();
  const char* const end = begin + line.size();
  if (SkipBlanks(begin, end) == end ||
    std::any_of(std::begin(others), std::end(others),
      [&](const char* record) { return BeginsWithRecord(begin, end, record); }))
  {
    return false;
  }
  int decimals = 0;
  int last = 0; // numbers at the end
  int beforeElement = 0;
  for (std::string_view field = TakeField(line); !field.empty() && field.front() != '#';
    field = TakeField(line))
  {
    double value;
    const char* const fieldEnd = field.data() + field.size();
    const bool isNumber = ParseNumber(field.data(), fieldEnd, value) == fieldEnd;
    decimals += isNumber && field.find('.') != field.npos;
    beforeElement = !isNumber && IsElement(field) ? last : 0;
    last = isNumber ? last + 1 : 0;
  }
  return decimals >= 3 || std::max(last, beforeElement) >= 5 ||
    HoldsCoordinates({ begin, static_cast<std::size_t>(end - begin) });
}
}
