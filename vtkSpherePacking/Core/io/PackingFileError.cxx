// SPDX-License-Identifier: BSD-3-Clause
#include "io/PackingFileError.h"

#include "bridge/PrintableText.h"

#include "vtkErrorCode.h"

#include <string_view>

namespace spherepacking
{
//------------------------------------------------------------------------------
void ThrowInFile(const std::string& file, const ContentError& error)
{
  const std::string location = error.Location.empty() ? "" : ", " + error.Location;
  throw PackingFileError(vtkErrorCode::FileFormatError, file + location + ": " + error.what());
}

//------------------------------------------------------------------------------
std::string Quote(const char* begin, const char* end)
{
  constexpr std::size_t longest = 40;
  return "'" + PrintableText(std::string_view(begin, end - begin), longest) + "'";
}
}
