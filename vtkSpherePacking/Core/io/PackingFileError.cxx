// SPDX-License-Identifier: BSD-3-Clause
#include "io/PackingFileError.h"

#include "vtkErrorCode.h"

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
  constexpr std::ptrdiff_t longest = 40;
  const bool clip = end - begin > longest;
  std::string text = "'";
  for (const char* p = begin; p != (clip ? begin + longest : end); ++p)
  {
    const auto byte = static_cast<unsigned char>(*p);
    if (byte == '\t')
    {
      text += ' ';
    }
    else if (byte < 0x20 || byte >= 0x7f)
    {
      // Escaped rather than passed through: the sentence must be valid UTF-8 whatever the file is.
      constexpr char digits[] = "0123456789abcdef";
      text += { '\\', 'x', digits[byte >> 4], digits[byte & 15] };
    }
    else
    {
      text += *p;
    }
  }
  return text + (clip ? "...'" : "'");
}
}
