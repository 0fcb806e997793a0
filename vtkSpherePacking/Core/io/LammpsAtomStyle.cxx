// SPDX-License-Identifier: BSD-3-Clause
#include "io/LammpsAtomStyle.h"

#include "io/Separators.h"

#include <algorithm>
#include <map>

namespace spherepacking
{
namespace
{
using Names = std::vector<std::string>;

// The columns by name, separated by blanks; "" if the style is not known.
std::string_view ColumnsOfSimpleStyle(std::string_view style)
{
  static const std::map<std::string_view, std::string_view> styles{
    { "angle", "id molecule type x y z" },
    { "atomic", "id type x y z" },
    { "body", "id type bodyflag mass x y z" },
    { "bond", "id molecule type x y z" },
    { "bpm/sphere", "id molecule type diameter density x y z" },
    { "charge", "id type q x y z" },
    { "dielectric", "id type q x y z mux muy muz area ed em epsilon curvature" },
    { "dipole", "id type q x y z mux muy muz" },
    { "dpd", "id type theta x y z" },
    { "edpd", "id type edpd_temp edpd_cv x y z" },
    { "electron", "id type q espin eradius x y z" },
    { "ellipsoid", "id type ellipsoidflag density x y z" },
    { "full", "id molecule type q x y z" },
    { "granular", "id type diameter density x y z" }, // LIGGGHTS
    { "line", "id molecule type lineflag density x y z" },
    { "mdpd", "id type rho x y z" },
    { "molecular", "id molecule type x y z" },
    { "peri", "id type volume density x y z" },
    { "smd", "id type molecule volume mass kradius cradius x0 y0 z0 x y z" },
    { "sph", "id type rho esph cv x y z" },
    { "sphere", "id type diameter density x y z" },
    { "spin", "id type x y z spx spy spz sp" },
    { "template", "id type molecule template_index template_atom x y z" },
    { "tri", "id molecule type triangleflag density x y z" },
    { "wavepacket", "id type q espin eradius etag cs_re cs_im x y z" },
  };
  // Accelerated variants have the columns of the plain one.
  for (const std::string_view suffix : { "/gpu", "/intel", "/kk", "/omp", "/opt" })
  {
    if (style.size() > suffix.size() && style.substr(style.size() - suffix.size()) == suffix)
    {
      style.remove_suffix(suffix.size());
    }
  }
  const auto found = styles.find(style);
  return found == styles.end() ? std::string_view() : found->second;
}

std::vector<std::string_view> Words(const std::string& line)
{
  return Separators::Blanks().Split(line.data());
}
}

//------------------------------------------------------------------------------
std::optional<std::vector<std::string>> ColumnsOfAtomStyle(std::string_view style)
{
  const std::string line = std::string(style) + '\n';
  std::vector<std::string_view> parts = Words(line);
  const bool hybrid = parts.size() > 1 && parts[0].substr(0, 6) == "hybrid";
  if (parts.empty() || (parts.size() > 1 && !hybrid))
  {
    return std::nullopt;
  }
  Names names;
  if (hybrid)
  {
    names = { "id", "type", "x", "y", "z" };
    parts.erase(parts.begin());
  }
  for (const std::string_view part : parts)
  {
    const std::string columns = std::string(ColumnsOfSimpleStyle(part)) + '\n';
    if (columns.size() == 1)
    {
      return std::nullopt;
    }
    for (const std::string_view name : Words(columns))
    {
      if (std::find(names.begin(), names.end(), name) == names.end())
      {
        names.emplace_back(name);
      }
    }
  }
  return names;
}
}
