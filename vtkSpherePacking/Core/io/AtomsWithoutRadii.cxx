// SPDX-License-Identifier: BSD-3-Clause
#include "io/FixedForms.h"
#include "io/LineScanner.h"
#include "io/PackingFileError.h"
#include "io/PdbRecord.h"

#include "vtkErrorCode.h"
#include "vtksys/SystemTools.hxx"

#include <map>

namespace spherepacking
{
namespace
{
constexpr char Pdb[] =
  "a PDB file, whose last numbers are occupancy and temperature factor (B-factor)";
constexpr char Cif[] = "an mmCIF file, which holds no radii";

// Whether every atom has its last two numbers where a PDB file has occupancy and temperature
// factor, and none of the former is beyond 0 to 1, as charges are.
bool LooksLikePdb(const TextRange& head)
{
  bool any = false;
  LineScanner scanner(head, {});
  while (scanner.Next())
  {
    const std::string_view line = scanner.WholeLine();
    if (IsAtomRecord(line.data(), line.data() + line.size()))
    {
      double occupancy;
      any = HoldsOccupancy(line) && ParseFinite(PdbColumns(line, 55, 60), occupancy) &&
        occupancy >= 0.0 && occupancy <= 1.0;
      if (!any)
      {
        return false;
      }
    }
  }
  return any;
}
}

//------------------------------------------------------------------------------
void RefuseAtomsWithoutRadii(const std::string& file, const TextRange& head)
{
  using vtksys::SystemTools;
  static const std::map<std::string, std::string> formats{ { ".pdb", Pdb }, { ".ent", Pdb },
    { ".cif", Cif }, { ".mmcif", Cif }, { ".bcif", Cif },
    { ".gro", "a file of GROMACS, which holds no radii" } };
  const auto found =
    formats.find(SystemTools::LowerCase(SystemTools::GetFilenameLastExtension(file)));
  LineScanner scanner(head);
  // The name of a block stands alone, unlike that of a column.
  const bool isCif =
    scanner.Next() && scanner.Line().substr(0, 5) == "data_" && scanner.Fields().size() == 1;
  const std::string what = found != formats.end()               ? found->second
    : isCif                                                     ? Cif
    : GuessFixedForm(head) == Format::Pqr && LooksLikePdb(head) ? Pdb
                                                                : "";
  if (what.empty())
  {
    return;
  }
  const bool molecule = what == Pdb || what == Cif;
  const bool byContent = found == formats.end() && what == Pdb;
  throw PackingFileError(vtkErrorCode::FileFormatError,
    file + ": found " + what + ", expected a file with radii" +
      (molecule ? "; in Python, spherepacking.read gives atoms of files named .pdb or .cif van "
                  "der Waals radii after pip install 'spherepacking[formats]'"
                : "") +
      (byContent ? "; name the file .pqr if these numbers are charge and radius" : ""));
}
}
