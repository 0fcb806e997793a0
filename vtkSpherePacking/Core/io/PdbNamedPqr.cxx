// SPDX-License-Identifier: BSD-3-Clause
#include "io/PdbNamedPqr.h"

#include "io/LineScanner.h"
#include "io/PackingFileError.h"
#include "io/PdbRecord.h"
#include "io/PqrRemarks.h"

namespace spherepacking
{
namespace
{
bool IsOccupancy(std::string_view field)
{
  double value;
  return ParseFinite(field, value) && value >= 0.0 && value <= 1.0;
}
}

//------------------------------------------------------------------------------
void RefusePdb(const TextRange& text)
{
  vtkIdType firstAtom = 0;
  vtkIdType number = text.FirstLine;
  LineFinder find(text.End);
  for (const char* p = text.Begin; p != text.End; ++number)
  {
    const char* const end = find(p);
    const std::string_view line(p, end - p);
    if (IsAtomRecord(p, end))
    {
      const std::string_view occupancy = PdbColumns(line, 55, 60);
      const bool isLikePdb = HoldsOccupancy(line) && (HoldsElement(line) || occupancy == "1.00");
      const bool isCharge =
        HoldsCoordinates(line) && HoldsFixedNumber(line, 55, 60, 2) && !IsOccupancy(occupancy);
      if ((firstAtom == 0 && !isLikePdb) || isCharge)
      {
        return;
      }
      firstAtom = firstAtom > 0 ? firstAtom : number;
    }
    p = SkipLineEnd(end, text.End);
  }
  if (firstAtom > 0 && !SaysRadiiInBFactors(text))
  {
    throw LineError(firstAtom,
      "found occupancy and temperature factor (B-factor) in the columns of a PDB file, expected "
      "charge and radius; rename the file to .pdb if it is one, or say radius=\"radius\" (--radius "
      "radius) if these numbers are charge and radius");
  }
}
}
