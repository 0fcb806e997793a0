// SPDX-License-Identifier: BSD-3-Clause
#include "io/CutFile.h"
#include "io/AtomRecord.h"
#include "io/FileBytes.h"
#include "io/Number.h"
#include "io/PackingFileError.h"
#include "bridge/PrintableText.h"
#include "io/PackingFormats.h"
#include "io/PdbModels.h"
#include "io/PdbNamedPqr.h"
#include "io/PqrRemarks.h"
#include "io/TextChunks.h"
#include "io/TextTable.h"
#include "io/Utf8Mark.h"

#include <algorithm>
#include <atomic>
#include <cmath>
#include <limits>
#include <optional>

namespace spherepacking
{
namespace
{
constexpr char Tail[] = "x y z charge radius and perhaps an element";
constexpr std::size_t Fewest = 10;
constexpr std::size_t Most = 13;

// What is wrong with a line, and where.
struct BadLine
{
  const char* At;
  std::string What;
};

// The arrays that the records fill. Those of text are there for every file, and taken away at the
// end if all of them are empty.
template <typename Real>
struct AtomArrays
{
  explicit AtomArrays(PackingArrays& arrays)
    : Centers(arrays.Centers<Real>())
    , Radii(arrays.Radii<Real>())
    , Charges(arrays.AddExtra("charge"))
    , ResidueIds(arrays.AddExtra("residue_id"))
    , Names(arrays.AddText("name"))
    , Residues(arrays.AddText("residue"))
    , Chains(arrays.AddText("chain"))
    , InsertionCodes(arrays.AddText("insertion_code"))
    , Elements(arrays.AddText("element"))
  {
  }

  Real* Centers;
  Real* Radii;
  double* Charges;
  double* ResidueIds;
  std::string* Names;
  std::string* Residues;
  std::string* Chains;
  std::string* InsertionCodes;
  std::string* Elements;
};

std::string QuoteField(std::string_view field)
{
  return Quote(field.data(), field.data() + field.size());
}

std::string DescribeFault(AtomFault fault, std::string_view line)
{
  const char* const begin = SkipBlanks(line.data(), line.data() + line.size());
  const std::string quoted = Quote(begin, line.data() + line.size());
  if (fault == AtomFault::TwoReadings)
  {
    return "found " + quoted +
      ", whose blanks say other coordinates than columns 31 to 54, expected x y z charge radius "
      "between blanks or from column 31 on";
  }
  std::size_t count = 0;
  bool within = false;
  for (const char c : line)
  {
    count += !IsBlank(c) && !within;
    within = !IsBlank(c);
  }
  const std::string found =
    "found " + std::to_string(count) + (count == 1 ? " column " : " columns ") + quoted;
  if (count >= Fewest && count <= Most)
  {
    return found + ", expected the last of them to be the number of the residue, " + Tail;
  }
  return found + ", expected " + std::to_string(Fewest) + " to " + std::to_string(Most) +
    " that end with " + Tail;
}

// Parses `field`; if it is no such number, sets what is wrong with it.
template <typename T>
bool ParseField(std::string_view field, const char* name, T& value, std::string& what)
{
  const char* const end = field.data() + field.size();
  const char* expected = nullptr;
  if (ParseNumber(field.data(), end, value) != end)
  {
    expected = "a number";
  }
  else if (!(std::abs(value) <= std::numeric_limits<T>::max()))
  {
    expected = "a finite number";
  }
  if (expected)
  {
    what = "found " + QuoteField(field) + " as " + name + " in a record that ends with " + Tail +
      ", expected " + expected;
  }
  return !expected;
}

/// Parses the records of chunks.
template <typename Real>
class RecordParser
{
public:
  RecordParser(const AtomArrays<Real>& arrays, bool radiusFirst)
    : To(arrays)
    , RadiusFirst(radiusFirst)
  {
  }

  void Parse(const TextChunk& chunk, std::optional<BadLine>& bad) const
  {
    LineFinder find(chunk.End);
    vtkIdType row = chunk.FirstRow;
    for (const char* p = chunk.Begin; p != chunk.End;)
    {
      const char* const end = find(p);
      const std::string_view line(p, end - p);
      std::string what;
      const bool good =
        IsAtomRecord(p, end) ? this->ParseAtom(line, row++, what) : CheckOtherRecord(line, what);
      if (!good)
      {
        bad = BadLine{ p, std::move(what) };
        return;
      }
      p = SkipLineEnd(end, chunk.End);
    }
  }

private:
  bool ParseAtom(std::string_view line, vtkIdType row, std::string& what) const
  {
    AtomRecord record;
    if (const AtomFault fault = SplitAtomRecord(line, record); fault != AtomFault::None)
    {
      what = DescribeFault(fault, line);
      return false;
    }
    if (this->RadiusFirst)
    {
      std::swap(record.Numbers[AtomRecord::Charge], record.Numbers[AtomRecord::Radius]);
    }
    constexpr const char* names[] = { "x", "y", "z" };
    for (int axis = 0; axis < 3; ++axis)
    {
      if (!ParseField(record.Numbers[axis], names[axis], this->To.Centers[3 * row + axis], what))
      {
        return false;
      }
    }
    const std::string_view radius = record.Numbers[AtomRecord::Radius];
    if (!ParseField(record.Numbers[AtomRecord::Charge], "charge", this->To.Charges[row], what) ||
      !ParseField(radius, "radius", this->To.Radii[row], what))
    {
      return false;
    }
    if (IsNegative(radius.data(), radius.data() + radius.size(), this->To.Radii[row]))
    {
      what = "found " + QuoteField(radius) + " as radius in a record that ends with " + Tail +
        ", expected a number that is not negative";
      return false;
    }
    this->Name(record, row);
    return true;
  }

  void Name(const AtomRecord& record, vtkIdType row) const
  {
    const std::string_view number = record.ResidueNumber;
    double& id = this->To.ResidueIds[row];
    if (!ParseNumber(number.data(), number.data() + number.size(), id))
    {
      id = std::numeric_limits<double>::quiet_NaN();
    }
    SetText(this->To.Names[row], record.Name);
    SetText(this->To.Residues[row], record.Residue);
    SetText(this->To.Chains[row], record.Chain);
    SetText(this->To.InsertionCodes[row], record.InsertionCode);
    SetText(this->To.Elements[row], record.Element);
  }

  // Such text must be valid UTF-8 whatever the file is.
  static void SetText(std::string& to, std::string_view field)
  {
    const bool plain =
      std::all_of(field.begin(), field.end(), [](char c) { return c >= ' ' && c <= '~'; });
    to = plain ? std::string(field) : PrintableText(field);
  }

  // Any other line is left out, unless it is a record of atoms whose name is damaged.
  static bool CheckOtherRecord(std::string_view line, std::string& what)
  {
    if (!LooksLikeDamagedAtom(line))
    {
      return true;
    }
    what = "found " + QuoteField(line) + ", expected ATOM, HETATM or a record without coordinates";
    return false;
  }

  const AtomArrays<Real>& To;
  bool RadiusFirst;
};

template <typename Real>
void ParseInto(
  PackingArrays& arrays, const std::vector<TextChunk>& chunks, bool radiusFirst, Progress& progress)
{
  const AtomArrays<Real> to(arrays);
  const RecordParser<Real> parser(to, radiusFirst);
  std::vector<std::optional<BadLine>> bad(chunks.size());
  std::atomic<bool> failed{ false };
  const auto parse = [&](vtkIdType first, vtkIdType last)
  {
    for (vtkIdType i = first; i < last; ++i)
    {
      parser.Parse(chunks[i], bad[i]);
      if (bad[i])
      {
        failed = true;
      }
    }
  };
  const auto throwIfFailed = [&]
  {
    for (std::size_t i = 0; failed && i < bad.size(); ++i)
    {
      if (bad[i])
      {
        throw LineError(
          chunks[i].FirstLine + CountLineEnds(chunks[i].Begin, bad[i]->At), bad[i]->What);
      }
    }
  };
  ForInBatches(static_cast<vtkIdType>(chunks.size()), 1, progress, parse, throwIfFailed);

  for (std::string* values : { to.Names, to.Residues, to.Chains, to.InsertionCodes, to.Elements })
  {
    if (std::all_of(values, values + arrays.GetCount(), [](const auto& v) { return v.empty(); }))
    {
      arrays.RemoveText(values);
    }
  }
}

// Programs end every line of an atom, though not all that of END.
void CheckLastAtomNotCut(const TextRange& text)
{
  const char* last = text.End;
  while (last != text.Begin && !IsLineEnd(last[-1]))
  {
    --last;
  }
  const std::string_view line(last, text.End - last);
  const auto begins = [line](std::string_view record)
  { return !line.empty() && record.substr(0, line.size()) == line; };
  if (IsAtomRecord(last, text.End) || begins("ATOM") || begins("HETATM"))
  {
    CheckNotCut(text);
  }
}

PackingArrays ParsePqr(const FileBytes& bytes, const ReadOptions& options, Progress& progress)
{
  progress.SetRange(0.2, 0.3);
  const TextRange all{ SkipUtf8Mark(bytes.Begin(), bytes.End()), bytes.End() };
  const PdbModels models = FindModels(all);
  const auto chunks = CutIntoChunks(models.First, RowKind::Atom, options.ChunkSize, 0, progress);
  const vtkIdType count = CountRows(chunks);
  if (count == 0)
  {
    ThrowNoSphere("ATOM or HETATM records that end with x y z charge radius");
  }
  if (!options.RadiusOptional) // who says which radii he means knows what the numbers are
  {
    RefusePdb(models.First);
  }
  if (models.First.End == all.End)
  {
    CheckLastAtomNotCut(all);
  }
  progress.SetRange(0.3, 1.0);
  PackingArrays arrays(count, options.Single);
  const auto parse = options.Single ? ParseInto<float> : ParseInto<double>;
  parse(arrays, chunks, SaysRadiusFirst(all), progress);
  if (models.Count > 1)
  {
    arrays.AddFieldValue("models", static_cast<double>(models.Count));
  }
  return arrays;
}
}

//------------------------------------------------------------------------------
PackingArrays ReadPqr(const std::string& file, const ReadOptions& options, Progress& progress)
{
  progress.SetRange(0.0, 0.2);
  const FileBytes bytes = FileBytes::Read(file, progress);
  return WithFileName(file, [&] { return ParsePqr(bytes, options, progress); });
}
}
