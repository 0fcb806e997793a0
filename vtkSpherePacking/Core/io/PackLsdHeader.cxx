// SPDX-License-Identifier: BSD-3-Clause
#include "io/PackLsdHeader.h"

namespace spherepacking
{
namespace
{
// The numbers of spheres and of species, and that of each species.
void ReadCounts(LineScanner& scanner, PackLsdHeader& header)
{
  const std::string expected = "the numbers of spheres and of species";
  scanner.Require(expected);
  const auto fields = scanner.Fields();
  vtkIdType species = 0;
  if (fields.size() != 2 || !ParseInteger(fields[0], header.Count) ||
    !ParseInteger(fields[1], species) || header.Count < 0 || species < 1)
  {
    scanner.Refuse(expected);
  }
  header.CountLine = scanner.LineNumber();

  const std::string each = "the number of spheres of each species, which add up to all";
  scanner.Require(each);
  vtkIdType sum = 0;
  for (const std::string_view field : scanner.Fields())
  {
    vtkIdType count;
    if (!ParseInteger(field, count) || count < 0 || count > header.Count - sum)
    {
      scanner.Refuse(each);
    }
    sum += count;
    header.Counts.push_back(count);
  }
  if (sum != header.Count || static_cast<vtkIdType>(header.Counts.size()) != species)
  {
    scanner.Refuse(each);
  }
}

// The letters of the axes; empty if the line has anything else.
std::vector<bool> PeriodicAxes(const LineScanner& scanner)
{
  std::vector<bool> axes;
  for (const std::string_view field : scanner.Fields())
  {
    if (field != "T" && field != "F")
    {
      return {};
    }
    axes.push_back(field == "T");
  }
  return axes;
}
}

//------------------------------------------------------------------------------
PackLsdHeader ReadPackLsdHeader(LineScanner& scanner)
{
  PackLsdHeader header{};
  scanner.Require("the dimension, 3", "no line");
  if (scanner.Line() != "3")
  {
    scanner.Refuse("the dimension, 3");
  }
  ReadCounts(scanner, header);

  // The numbers up to the letters: those of the cell, perhaps after the diameters.
  std::vector<std::string_view> numbers;
  const std::size_t species = header.Counts.size();
  const std::string expected = "the vectors of the cell, then T or F for each axis";
  std::vector<bool> axes;
  for (scanner.Require(expected); (axes = PeriodicAxes(scanner)).empty(); scanner.Require(expected))
  {
    for (const std::string_view field : scanner.Fields())
    {
      double value;
      if (!ParseFinite(field, value) || numbers.size() == species + 9)
      {
        scanner.Refuse(expected);
      }
      numbers.push_back(field);
    }
  }
  if (axes.size() != 3 || (numbers.size() != 9 && numbers.size() != species + 9))
  {
    scanner.Refuse("T or F for each of 3 axes after the 9 numbers of the cell");
  }
  header.Diameters.assign(numbers.begin(), numbers.end() - 9);
  for (std::size_t i = 0; i < 9; ++i)
  {
    ParseFinite(numbers[numbers.size() - 9 + i], header.Cell.Vectors[i / 3][i % 3]);
  }
  header.Cell.Periodic = { axes[0], axes[1], axes[2] };
  return header;
}
}
