// SPDX-License-Identifier: BSD-3-Clause
#include "io/PackingFileError.h"

#include "vtkErrorCode.h"

#include <algorithm>
#include <cstddef>

namespace spherepacking
{
//------------------------------------------------------------------------------
void ThrowInFile(const std::string& file, const ContentError& error)
{
  const std::string location = error.Location.empty() ? "" : ", " + error.Location;
  throw PackingFileError(vtkErrorCode::FileFormatError, file + location + ": " + error.what());
}

//------------------------------------------------------------------------------
std::string Printable(std::string_view bytes)
{
  std::string text;
  for (const char c : bytes)
  {
    const auto byte = static_cast<unsigned char>(c);
    if (byte == '\t')
    {
      text += ' ';
    }
    else if (byte < 0x20 || byte >= 0x7f)
    {
      // Escaped rather than passed through: text must be valid UTF-8 whatever the file is.
      constexpr char digits[] = "0123456789abcdef";
      text += { '\\', 'x', digits[byte >> 4], digits[byte & 15] };
    }
    else
    {
      text += c;
    }
  }
  return text;
}

//------------------------------------------------------------------------------
std::string Quote(const char* begin, const char* end)
{
  constexpr std::ptrdiff_t longest = 40;
  const std::ptrdiff_t length = std::min(end - begin, longest);
  const std::string text = Printable(std::string_view(begin, static_cast<std::size_t>(length)));
  return "'" + text + (length < end - begin ? "...'" : "'");
}
}
