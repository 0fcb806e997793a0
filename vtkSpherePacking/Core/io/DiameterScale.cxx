// SPDX-License-Identifier: BSD-3-Clause
#include "io/FileBytes.h"
#include "io/Number.h"
#include "io/PackingFileError.h"
#include "io/PackingFormats.h"
#include "io/TextLines.h"

#include "vtkErrorCode.h"
#include "vtksys/SystemTools.hxx"

#include <algorithm>
#include <cmath>
#include <string_view>

namespace spherepacking
{
namespace
{
// The number after `label`, with blanks around it.
double Porosity(const FileBytes& bytes, std::string_view label)
{
  const std::string_view text(bytes.Begin(), bytes.End() - bytes.Begin());
  const std::size_t at = text.find(label);
  const std::string expected =
    " for '" + std::string(label) + "', expected a number from 0 to below 1";
  if (at == text.npos)
  {
    throw ContentError("found no such line" + expected);
  }
  const char* first = SkipBlanks(text.data() + at + label.size(), bytes.End());
  const char* last =
    std::find_if(first, bytes.End(), [](char c) { return IsBlank(c) || IsLineEnd(c); });
  double porosity = -1.0;
  if (ParseNumber(first, bytes.End(), porosity) != last || !(porosity >= 0.0 && porosity < 1.0))
  {
    throw LineError(
      1 + CountLineEnds(bytes.Begin(), first), "found " + Quote(first, last) + expected);
  }
  return porosity;
}
}

//------------------------------------------------------------------------------
double DiameterScale(const std::string& xyzdFile)
{
  using vtksys::SystemTools;
  const std::string path = SystemTools::GetFilenamePath(xyzdFile);
  const std::string name = SystemTools::GetFilenameWithoutLastExtension(xyzdFile) + ".nfo";
  const std::string file = path.empty() ? name : path + "/" + name;
  if (!SystemTools::FileExists(file, true))
  {
    return 1.0;
  }
  if (SystemTools::FileLength(file) == 0)
  {
    throw PackingFileError(
      vtkErrorCode::FileFormatError, file + ": the file is empty, expected two porosities");
  }
  const FileBytes bytes = FileBytes::ReadHead(file, 1 << 16);
  // V. Baranau and U. Tallarek, "Random-close packing limits for monodisperse and polydisperse
  // hard spheres", 2014, whose program stores the diameters before its last rescaling.
  const auto scale = [&]
  {
    return std::cbrt((1.0 - Porosity(bytes, "Final Porosity:")) /
      (1.0 - Porosity(bytes, "Theoretical Porosity:")));
  };
  return WithFileName(file, scale);
}
}
