// SPDX-License-Identifier: BSD-3-Clause
#include "io/NameMeaning.h"

#include <algorithm>
#include <array>
#include <iterator>
#include <map>
#include <set>

namespace spherepacking
{
namespace
{
using Words = std::set<std::string_view>;

// Not std::tolower, which depends on the locale.
char Lower(char c)
{
  return c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c;
}

// In lower case, words separated by one _ each: "equivalent_diameter" of "Equivalent-Diameter".
std::string PlainWords(std::string_view text)
{
  std::string plain;
  for (const char c : text)
  {
    const bool between = std::string_view(" \t_-.:").find(c) != std::string_view::npos;
    if (!between)
    {
      plain += Lower(c);
    }
    else if (!plain.empty() && plain.back() != '_')
    {
      plain += '_';
    }
  }
  while (!plain.empty() && plain.back() == '_')
  {
    plain.pop_back();
  }
  return plain;
}

std::string_view TrimBlanks(std::string_view text)
{
  const std::size_t first = std::min(text.find_first_not_of(" \t"), text.size());
  return text.substr(first, text.find_last_not_of(" \t") + 1 - first);
}

// Takes the unit off the end of a name: "[mm]", "(mm)", or "mm" behind one of _/:.-
std::string_view TakeUnit(std::string_view name, NameMeaning& meaning)
{
  if (const std::size_t at = name.find_first_of("(["); at != name.npos)
  {
    const std::size_t end = std::min(name.find_first_of(")]", at), name.size());
    const std::string_view text = TrimBlanks(name.substr(at + 1, end - at - 1));
    meaning.Unit = UnitInBracket(text);
    if (meaning.Unit.empty() && text.find_first_not_of("0123456789") != text.npos)
    {
      std::transform(text.begin(), text.end(), std::back_inserter(meaning.Unknown), Lower);
    }
    return TrimBlanks(name.substr(0, at));
  }
  name = TrimBlanks(name);
  if (const std::size_t at = name.find_last_of(" \t_/:.-"); at != name.npos)
  {
    meaning.Unit = LengthUnit(name.substr(at + 1));
    meaning.IsUnitGlued = !meaning.Unit.empty();
    name = meaning.IsUnitGlued ? TrimBlanks(name.substr(0, at)) : name;
    const std::size_t in = name.size() < 4 ? name.npos : name.size() - 3;
    const bool said = meaning.IsUnitGlued && in != name.npos && // "radius in mm"
      (name.substr(in) == " in" || name.substr(in) == "_in");
    return said ? TrimBlanks(name.substr(0, in)) : name;
  }
  return name;
}

bool IsPlace(std::string_view word)
{
  static const Words places{ "pos", "position", "positions", "center", "centre", "centers",
    "centres", "coord", "coords", "coordinate", "coordinates", "point", "points", "centroid",
    "centroids", "location", "loc", "com", "c", "koordinate", "koordinaten", "mittelpunkt",
    "coordinata", "coordenada" };
  return places.count(word) > 0;
}

// pos_x, posx, x_pos, xpos, points_0: the axis, with the place before or after it.
bool FindAxis(const std::string& plain, NameMeaning& meaning)
{
  const auto take = [&](std::size_t at, std::string_view place, std::string_view axes)
  {
    const std::size_t axis = axes.find(plain[at]);
    while (!place.empty() && (place.front() == '_' || place.back() == '_'))
    {
      place = place.front() == '_' ? place.substr(1) : place.substr(0, place.size() - 1);
    }
    if (axis == axes.npos || !(place.empty() || IsPlace(place)))
    {
      return false;
    }
    meaning.What = NameMeaning::Coordinate;
    meaning.Axis = static_cast<int>(axis);
    meaning.Family = plain;
    meaning.Family[at] = '*';
    return true;
  };
  const std::string_view view = plain;
  const std::size_t last = plain.size() - 1;
  // c_0 is what LAMMPS and others call any result of theirs.
  const bool numbered = plain.size() > 3 && plain[last - 1] == '_';
  return take(last, view.substr(0, last), "xyz") || take(0, view.substr(1), "xyz") ||
    (numbered && take(last, view.substr(0, last), "012"));
}

// Whether all words of "equivalent_sphere" say what a radius or a diameter is of.
bool AreOwners(std::string_view words)
{
  static const Words owners{ "equivalent", "equiv", "eq", "effective", "eff", "inscribed", "sphere",
    "spheres", "spherical", "particle", "grain", "ball", "bead", "atom", "atomic", "pore", "bubble",
    "droplet", "vdw" };
  for (std::size_t cut = 0; cut != words.npos;)
  {
    cut = words.find('_');
    if (owners.count(words.substr(0, cut)) == 0)
    {
      return false;
    }
    words = cut == words.npos ? words : words.substr(cut + 1);
  }
  return true;
}

// radius, r, particle_radius and so on, or the same of a diameter.
void FindSize(const std::string& plain, NameMeaning& meaning)
{
  struct Size
  {
    NameMeaning::Kind Kind;
    Words Full;
    Words Short;
    Words OfParts; // of a particle, effective, equivalent
  };
  static const Words radii{ "radius", "radii", "halbmesser", "rayon", "raggio", "radio", "promień",
    "raio", "straal", "yarıçap", "반지름", "радиус", "Радиус", "半径" };
  // The last two in Latin-1, which spreadsheets save.
  static const Words diameters{ "diameter", "diameters", "durchmesser", "diametro", "diametre",
    "diamètre", "diámetro", "średnica", "çap", "지름", "диаметр", "Диаметр", "直径", "diam\350tre",
    "di\341metro" };
  static const std::array<Size, 2> sizes{ {
    { NameMeaning::Radius, radii, { "r", "rad" }, { "rp", "r_p", "reff", "r_eff", "r_eq" } },
    { NameMeaning::Diameter, diameters, { "d", "diam" }, { "dp", "d_p", "deff", "d_eff", "d_eq" } },
  } };
  const std::string_view view = plain;
  const std::size_t cut = view.rfind('_');
  const std::string_view word = cut == view.npos ? view : view.substr(cut + 1);
  const bool owned = cut != view.npos && AreOwners(view.substr(0, cut));
  for (const Size& size : sizes)
  {
    const bool full = size.Full.count(word) > 0;
    const bool ofParts = size.OfParts.count(view) > 0;
    if ((full && (owned || cut == view.npos)) || size.Short.count(view) > 0 || ofParts)
    {
      meaning.What = size.Kind;
      meaning.IsOfParts = ofParts;
      meaning.IsFullWord = full && !owned;
      meaning.IsLetter = view == "r";
      return;
    }
  }
}
}

//------------------------------------------------------------------------------
std::string LengthUnit(std::string_view word)
{
  static const std::map<std::string, std::string> units{ { "m", "m" }, { "meter", "m" },
    { "metre", "m" }, { "meters", "m" }, { "metres", "m" }, { "dm", "dm" }, { "cm", "cm" },
    { "mm", "mm" }, { "um", "um" }, { "µm", "um" }, { "μm", "um" }, { "micron", "um" },
    { "microns", "um" }, { "nm", "nm" }, { "pm", "pm" }, { "km", "km" }, { "å", "A" }, { "Å", "A" },
    { "Å", "A" }, { "angstrom", "A" }, { "angstroms", "A" }, { "inch", "inch" },
    { "inches", "inch" }, { "ft", "ft" }, { "px", "px" }, { "pixel", "px" }, { "pixels", "px" },
    { "vox", "voxel" }, { "voxel", "voxel" }, { "voxels", "voxel" } };
  std::string lower(word);
  std::transform(lower.begin(), lower.end(), lower.begin(), Lower);
  const auto found = units.find(lower);
  return found == units.end() ? std::string() : found->second;
}

//------------------------------------------------------------------------------
std::string WithPlainBlanks(std::string_view text)
{
  std::string plain;
  for (std::size_t p = 0; p < text.size(); ++p)
  {
    const bool space = text.substr(p, NoBreakSpace.size()) == NoBreakSpace;
    plain += space ? ' ' : text[p];
    p += space ? 1 : 0;
  }
  return plain;
}

//------------------------------------------------------------------------------
std::string UnitInBracket(std::string_view text)
{
  // Too short, or too much like other words, to be units elsewhere.
  static const std::map<std::string_view, std::string_view> others{ { "A", "A" }, { "Ang", "A" },
    { "ang", "A" }, { "in", "inch" }, { "µ", "um" }, { "μ", "um" }, { "mum", "um" },
    { "bohr", "bohr" }, { "pc", "pc" }, { "kpc", "kpc" }, { "Mpc", "Mpc" } };
  text = TrimBlanks(text);
  text = text.substr(0, 3) == "in " ? TrimBlanks(text.substr(3)) : text;
  const auto other = others.find(text);
  return other != others.end() ? std::string(other->second) : LengthUnit(text);
}

//------------------------------------------------------------------------------
std::optional<NameMeaning> CoordinateOfParticle(std::string_view name)
{
  NameMeaning meaning;
  std::string plain = PlainWords(TakeUnit(name, meaning));
  if (plain.size() == 3 && plain[1] == '_')
  {
    plain.erase(1, 1);
  }
  const std::size_t p = plain.size() == 2 ? plain.find('p') : plain.npos;
  const std::size_t axis = p == plain.npos ? p : std::string_view("xyz").find(plain[1 - p]);
  if (axis == plain.npos)
  {
    return std::nullopt;
  }
  meaning.What = NameMeaning::Coordinate;
  meaning.Axis = static_cast<int>(axis);
  plain[1 - p] = '*';
  meaning.Family = std::move(plain);
  return meaning;
}

//------------------------------------------------------------------------------
NameMeaning MeaningOfName(std::string_view name)
{
  static const std::map<std::string, NameMeaning::Kind> others{ { "g", NameMeaning::Green },
    { "green", NameMeaning::Green }, { "b", NameMeaning::Blue }, { "blue", NameMeaning::Blue },
    { "theta", NameMeaning::PolarAngle }, { "θ", NameMeaning::PolarAngle },
    { "polar", NameMeaning::PolarAngle }, { "inclination", NameMeaning::PolarAngle },
    { "elevation", NameMeaning::PolarAngle }, { "phi", NameMeaning::Azimuth },
    { "φ", NameMeaning::Azimuth }, { "ϕ", NameMeaning::Azimuth },
    { "azimuth", NameMeaning::Azimuth } };
  if (name.find(NoBreakSpace) != name.npos)
  {
    return MeaningOfName(WithPlainBlanks(name));
  }
  NameMeaning meaning;
  const std::string plain = PlainWords(TakeUnit(name, meaning));
  if (plain.empty())
  {
    return meaning;
  }
  if (const auto other = others.find(plain); other != others.end())
  {
    meaning.What = other->second;
    return meaning;
  }
  if (!FindAxis(plain, meaning))
  {
    FindSize(plain, meaning);
  }
  if (meaning.What == NameMeaning::Coordinate && meaning.IsUnitGlued)
  {
    meaning.Family += '_' + meaning.Unit;
  }
  return meaning;
}

//------------------------------------------------------------------------------
bool IsPosition(std::string_view name)
{
  NameMeaning unused;
  const std::string plain = PlainWords(TakeUnit(name, unused));
  return plain == "xyz" || (IsPlace(plain) && plain != "c" && plain != "com");
}

//------------------------------------------------------------------------------
bool IsUnit(std::string_view word)
{
  // None of a letter but m: g may be green and n a number.
  static const Words others{ "kg", "Pa", "kPa", "MPa", "GPa", "deg" };
  return !LengthUnit(word).empty() || others.count(word) > 0 ||
    (word.find_first_of("/^") != word.npos && !IsOfSphere(MeaningOfName(word)));
}

//------------------------------------------------------------------------------
bool IsNameOfTwoWords(std::string_view first, std::string_view second)
{
  static const Words things{ "particle", "grain", "atom", "sphere", "ball", "bead", "point", "node",
    "body", "clump", "material", "pore", "cell", "molecule", "residue", "element", "group",
    "cluster" };
  static const Words properties{ "id", "ids", "number", "no", "nr", "num", "index", "idx", "type",
    "name", "radius", "diameter" };
  const std::string a = PlainWords(first);
  const std::string b = PlainWords(second);
  const bool axis = b == "x" || b == "y" || b == "z";
  const bool axisFirst = a == "x" || a == "y" || a == "z";
  return (things.count(a) > 0 && properties.count(b) > 0) || (IsPlace(a) && a != "c" && axis) ||
    (axisFirst && IsPlace(b) && b != "c") || a == "equivalent" ||
    (axis && (a == "velocity" || a == "force")) || (b == "number" && a == "coordination") ||
    (b == "fraction" && a == "volume");
}
}
