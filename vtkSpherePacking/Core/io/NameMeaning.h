// SPDX-License-Identifier: BSD-3-Clause
#ifndef NameMeaning_h
#define NameMeaning_h

#include <optional>
#include <string>
#include <string_view>

namespace spherepacking
{
/// What the name of a column means by itself, before the names beside it are looked at.
struct NameMeaning
{
  enum Kind : unsigned char
  {
    Other,
    Coordinate,
    Radius,
    Diameter,
    Green,
    Blue,
    PolarAngle,
    Azimuth,
    Kinds
  };
  Kind What = Other;
  bool IsFullWord = false;  ///< radius or diameter, neither shortened nor with words before it
  bool IsLetter = false;    ///< r, which may be red or a distance, too
  bool IsOfParts = false;   ///< a letter and what it is of: Rp, d_eq
  bool IsUnitGlued = false; ///< the unit follows without brackets, as in r_mm
  int Axis = 0;
  std::string Family;  ///< of a coordinate: its name with * for the axis
  std::string Unit;    ///< of length, in one spelling, if there is one
  std::string Unknown; ///< what is in brackets behind the name, if it is no unit that is known
};

/// Whether a name is that of a coordinate or a size.
inline bool IsOfSphere(const NameMeaning& meaning)
{
  return meaning.What == NameMeaning::Coordinate || meaning.What == NameMeaning::Radius ||
    meaning.What == NameMeaning::Diameter;
}

/// The family of x, y, z.
constexpr const char* PlainFamily = "*";

/// The meaning of a name such as px or x_p if it is a coordinate; a momentum may be called so, too.
std::optional<NameMeaning> CoordinateOfParticle(std::string_view name);

NameMeaning MeaningOfName(std::string_view name);

/// A blank that keeps words together, which spreadsheets and web pages put between any.
constexpr std::string_view NoBreakSpace = "\xC2\xA0";

/// The text with other blanks in place of these.
std::string WithPlainBlanks(std::string_view text);

/// The unit in a bracket, "mm" or "in mm", in one spelling, or nothing.
std::string UnitInBracket(std::string_view text);

/// Whether a name stands for all three coordinates, such as position or xyz.
bool IsPosition(std::string_view name);

/// The unit of length that a word is, in one spelling, or nothing.
std::string LengthUnit(std::string_view word);

/// Whether a word is a unit, such as mm or kg/m^3.
bool IsUnit(std::string_view word);

/// Whether two words are one name, such as "particle id".
bool IsNameOfTwoWords(std::string_view first, std::string_view second);
}

#endif
