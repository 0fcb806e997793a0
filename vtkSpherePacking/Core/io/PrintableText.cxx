// SPDX-License-Identifier: BSD-3-Clause
#include "io/PrintableText.h"

#include "vtk_utf8.h"

#include <algorithm>
#include <cstdint>

namespace spherepacking
{
namespace
{
// Controls, and what changes the order or the lines of the text around it.
bool HasNoShape(std::uint32_t c)
{
  return c < 0x20 || (c >= 0x7f && c < 0xa0) || (c >= 0x200b && c <= 0x200f) ||
    (c >= 0x2028 && c <= 0x202e) || (c >= 0x2060 && c <= 0x206f) || c == 0xfeff;
}

void Escape(std::string& text, const char* begin, const char* end)
{
  constexpr char digits[] = "0123456789abcdef";
  for (; begin != end; ++begin)
  {
    const auto byte = static_cast<unsigned char>(*begin);
    text += { '\\', 'x', digits[byte >> 4], digits[byte & 15] };
  }
}

// Appends [p, end), which is valid, up to `longest` characters; returns how far it came.
const char* Append(std::string& text, const char* p, const char* end, std::size_t& longest)
{
  for (; p != end && longest > 0; --longest)
  {
    const char* const first = p;
    const std::uint32_t character = utf8::unchecked::next(p);
    if (*first == '\t')
    {
      text += ' ';
    }
    else if (HasNoShape(character))
    {
      Escape(text, first, p);
    }
    else
    {
      text.append(first, p);
    }
  }
  return p;
}
}

//------------------------------------------------------------------------------
std::string PrintableText(std::string_view bytes, std::size_t longest)
{
  const auto plain = [](char c) { return c >= ' ' && c < 0x7f; };
  if (bytes.size() <= longest && std::all_of(bytes.begin(), bytes.end(), plain))
  {
    return std::string(bytes);
  }
  constexpr std::size_t bytesOfCharacter = 4;
  const char* const end = bytes.data() +
    (longest < bytes.size() / bytesOfCharacter ? bytesOfCharacter * (longest + 1) : bytes.size());
  std::string text;
  const char* p = bytes.data();
  while (p != end && longest > 0)
  {
    const char* const invalid = utf8::find_invalid(p, end);
    p = Append(text, p, invalid, longest);
    if (p == invalid && p != end && longest > 0)
    {
      Escape(text, p, p + 1);
      ++p;
      --longest;
    }
  }
  return p == bytes.data() + bytes.size() ? text : text + "...";
}
}
