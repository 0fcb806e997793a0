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
  std::string text = PrintableText(std::string_view(begin, end - begin), longest);
  // Nobody sees that it is no blank, which is what is wrong where it stands between numbers.
  constexpr std::string_view noBreakSpace = "\xC2\xA0";
  for (std::size_t at = text.find(noBreakSpace); at != text.npos; at = text.find(noBreakSpace, at))
  {
    text.replace(at, noBreakSpace.size(), "\\xc2\\xa0");
  }
  return "'" + text + "'";
}
}
