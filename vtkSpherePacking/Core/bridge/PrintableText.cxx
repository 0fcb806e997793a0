// SPDX-License-Identifier: BSD-3-Clause
#include "bridge/PrintableText.h"

#include "vtk_utf8.h"

#include <algorithm>
#include <cstdint>
#include <iterator>

namespace spherepacking
{
namespace
{
struct CharacterRange
{
  std::uint32_t First;
  std::uint32_t Last;
};

// Controls, and what changes the order or the lines of the text around it, or has no shape:
// printable.py has the same.
constexpr CharacterRange Hidden[] = { { 0, 0x1f }, { 0x7f, 0x9f }, { 0xad, 0xad }, { 0x61c, 0x61c },
  { 0x180e, 0x180e }, { 0x200b, 0x200f }, { 0x2028, 0x202e }, { 0x2060, 0x206f },
  { 0xfeff, 0xfeff }, { 0xfff9, 0xfffb }, { 0xe0000, 0xe007f } };

bool HasNoShape(std::uint32_t c)
{
  const auto holds = [c](CharacterRange range) { return c >= range.First && c <= range.Last; };
  return std::any_of(std::begin(Hidden), std::end(Hidden), holds);
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

//------------------------------------------------------------------------------
std::string PrintableSentence(std::string_view sentence)
{
  constexpr std::size_t most = 1000;
  constexpr std::size_t ends = 300;
  std::string text = PrintableText(sentence);
  if (text.size() <= most)
  {
    return text;
  }
  // Bytes that go on with a character begin with the bits 10.
  const auto startAt = [&text](std::size_t at)
  {
    while (at < text.size() && (text[at] & 0xc0) == 0x80)
    {
      ++at;
    }
    return at;
  };
  const std::size_t first = startAt(ends);
  const std::size_t last = startAt(text.size() - ends);
  return text.substr(0, first) + " ... (" + std::to_string(last - first) + " more bytes) ... " +
    text.substr(last);
}
}
