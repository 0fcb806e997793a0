// SPDX-License-Identifier: BSD-3-Clause
#ifndef AtomRecord_h
#define AtomRecord_h

#include <string_view>

namespace spherepacking
{
/// The fields of an ATOM or HETATM record of a PQR file, as text.
struct AtomRecord
{
  /// What stands in Numbers, in the order of the file.
  enum Number
  {
    X,
    Y,
    Z,
    Charge,
    Radius
  };

  std::string_view Numbers[5];
  std::string_view Name;
  std::string_view Residue;
  std::string_view Chain;         ///< may be empty
  std::string_view ResidueNumber; ///< empty if it is none
  std::string_view InsertionCode; ///< may be empty
  std::string_view Element;       ///< may be empty
};

/// What is wrong with a record.
enum class AtomFault
{
  None,
  WrongFields,
  TwoReadings ///< blanks between the fields say other coordinates than the columns 31 to 54
};

/**
 * Splits an ATOM or HETATM record. Its fields stand between blanks: record, serial number, name,
 * residue, chain, number of the residue, insertion code, x, y, z, charge, radius, element, of which
 * chain, insertion code and element may be missing (T. Dolinsky et al., "PDB2PQR: an automated
 * pipeline for the setup of Poisson-Boltzmann electrostatics calculations", 2004). Many programs
 * write them into the columns of a PDB file instead, where a number that fills its columns touches
 * the one before; then the columns decide. The numbers are not parsed.
 */
AtomFault SplitAtomRecord(std::string_view line, AtomRecord& record);

/// Whether a line that begins with neither ATOM nor HETATM holds the numbers of an atom, so that
/// its name must be damaged. Neither another record of the Protein Data Bank does, nor prose.
bool LooksLikeDamagedAtom(std::string_view line);
}

#endif
