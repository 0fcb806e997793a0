// SPDX-License-Identifier: BSD-3-Clause
#include "io/CutFile.h"
#include "io/FileBytes.h"
#include "io/LineCursor.h"
#include "io/LineScanner.h"
#include "io/PackingFileError.h"
#include "io/PackingFormats.h"

#include "vtkErrorCode.h"
#include "vtksys/SystemTools.hxx"

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <optional>
#include <string_view>
#include <system_error>

namespace spherepacking
{
namespace
{
/// What follows a label at the beginning of a line.
struct Entry
{
  std::string_view Value; ///< up to a blank
  vtkIdType Line;
};

// The entry of `label`, of which there may be one.
std::optional<Entry> FindEntry(const FileBytes& bytes, std::string_view label)
{
  std::optional<Entry> entry;
  LineCursor lines({ bytes.Begin(), bytes.End() });
  while (lines.Step())
  {
    const std::string_view line = lines.Line();
    const char* const end = line.data() + line.size();
    const char* const first = SkipBlanks(line.data(), end);
    if (std::string_view(first, end - first).substr(0, label.size()) != label)
    {
      continue;
    }
    if (entry)
    {
      throw LineError(lines.Number(),
        "found a second line " + std::string(label) + ", expected one, as in line " +
          std::to_string(entry->Line));
    }
    const char* const value = SkipBlanks(first + label.size(), end);
    const char* const last = std::find_if(value, end, IsBlank);
    entry = { { value, static_cast<std::size_t>(last - value) }, lines.Number() };
  }
  return entry;
}

double Porosity(const FileBytes& bytes, std::string_view label)
{
  const auto entry = FindEntry(bytes, label);
  const std::string expected =
    " for '" + std::string(label) + "', expected a number from 0 to below 1";
  if (!entry)
  {
    throw ContentError("found no such line" + expected);
  }
  double porosity;
  if (!ParseFinite(entry->Value, porosity) || !(porosity >= 0.0 && porosity < 1.0))
  {
    throw LineError(entry->Line,
      "found " + Quote(entry->Value.data(), entry->Value.data() + entry->Value.size()) + expected);
  }
  if (entry->Value.data() + entry->Value.size() == bytes.End())
  {
    CheckNotCut({ bytes.Begin(), bytes.End() });
  }
  return porosity;
}

// Some leave out the number of spheres, but none has another.
void CheckCount(const FileBytes& bytes, unsigned long long count)
{
  const auto entry = FindEntry(bytes, "N:");
  unsigned long long found = 0;
  if (entry && (!ParseInteger(entry->Value, found) || found != count))
  {
    throw LineError(entry->Line,
      "found " + Quote(entry->Value.data(), entry->Value.data() + entry->Value.size()) +
        " as the number of spheres, expected " + std::to_string(count) +
        ", as many as the .xyzd file beside it has");
  }
}

// Whether there is a file of this name with anything in it. Throws if there is an entry of this
// name that is none, such as a link to nothing.
bool IsThere(const std::string& file)
{
  namespace fs = std::filesystem;
  const fs::path path = fs::u8path(file);
  std::error_code error;
  const fs::file_type entry = fs::symlink_status(path, error).type();
  if (entry == fs::file_type::not_found)
  {
    return false;
  }
  const fs::file_type target = fs::status(path, error).type();
  if (entry == fs::file_type::symlink &&
    (target == fs::file_type::not_found || target == fs::file_type::none))
  {
    throw PackingFileError(vtkErrorCode::CannotOpenFileError,
      file + ": found a link that leads to no file, expected two porosities");
  }
  if (target == fs::file_type::regular && fs::file_size(path, error) == 0)
  {
    throw PackingFileError(
      vtkErrorCode::FileFormatError, file + ": the file is empty, expected two porosities");
  }
  return true;
}
}

//------------------------------------------------------------------------------
double DiameterScale(const std::string& xyzdFile, std::optional<vtkIdType> count)
{
  using vtksys::SystemTools;
  const std::string path = SystemTools::GetFilenamePath(xyzdFile);
  const std::string name = SystemTools::GetFilenameWithoutLastExtension(xyzdFile) + ".nfo";
  const std::string file = path.empty() ? name : path + "/" + name;
  if (!IsThere(file))
  {
    return 1.0;
  }
  const FileBytes bytes = FileBytes::ReadHead(file, 1 << 16);
  // V. Baranau and U. Tallarek, "Random-close packing limits for monodisperse and polydisperse
  // hard spheres", 2014, whose program stores the diameters before its last rescaling.
  const auto scale = [&]
  {
    if (count)
    {
      CheckCount(bytes, static_cast<unsigned long long>(*count));
    }
    return std::cbrt((1.0 - Porosity(bytes, "Final Porosity:")) /
      (1.0 - Porosity(bytes, "Theoretical Porosity:")));
  };
  return WithFileName(file, scale);
}
}
