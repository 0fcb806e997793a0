// SPDX-License-Identifier: BSD-3-Clause
#include "io/UnicodeText.h"

#include "io/PackingFileError.h"

#include "vtk_utf8.h"

#include <cstddef>
#include <cstdint>
#include <iterator>
#include <string>
#include <string_view>
#include <utility>

namespace spherepacking
{
namespace
{
struct Encoding
{
  const char* Name;
  std::string_view Mark;
  std::size_t Unit; // bytes
  bool LittleEndian;
};

// UTF-32 before UTF-16, since the one mark begins with the other.
constexpr Encoding Encodings[] = { { "UTF-32", { "\xFF\xFE\0\0", 4 }, 4, true },
  { "UTF-32", { "\0\0\xFE\xFF", 4 }, 4, false }, { "UTF-16", { "\xFF\xFE", 2 }, 2, true },
  { "UTF-16", { "\xFE\xFF", 2 }, 2, false } };

const Encoding* EncodingOf(std::string_view text)
{
  for (const Encoding& encoding : Encodings)
  {
    if (text.substr(0, encoding.Mark.size()) == encoding.Mark)
    {
      return &encoding;
    }
  }
  return nullptr;
}

std::string_view View(const FileBytes& bytes)
{
  return std::string_view(bytes.Begin(), bytes.End() - bytes.Begin());
}

std::uint32_t UnitAt(const Encoding& encoding, std::string_view text, std::size_t at)
{
  std::uint32_t unit = 0;
  for (std::size_t i = 0; i < encoding.Unit; ++i)
  {
    const std::size_t byte = encoding.LittleEndian ? encoding.Unit - 1 - i : i;
    unit = unit << 8 | static_cast<unsigned char>(text[at + byte]);
  }
  return unit;
}

constexpr bool IsHighSurrogate(std::uint32_t unit)
{
  return unit >= 0xD800 && unit < 0xDC00;
}

constexpr bool IsLowSurrogate(std::uint32_t unit)
{
  return unit >= 0xDC00 && unit < 0xE000;
}

[[noreturn]] void ThrowBroken(const Encoding& encoding, std::size_t at)
{
  throw ContentError(std::string("found text in ") + encoding.Name + " with no character at byte " +
    std::to_string(at + 1) + ", expected a valid one, or text in UTF-8");
}

std::string Decode(const Encoding& encoding, std::string_view text)
{
  std::string utf8;
  utf8.reserve(text.size());
  for (std::size_t at = encoding.Mark.size(); at < text.size(); at += encoding.Unit)
  {
    if (text.size() - at < encoding.Unit)
    {
      ThrowBroken(encoding, at);
    }
    std::uint32_t character = UnitAt(encoding, text, at);
    if (encoding.Unit == 2 && IsHighSurrogate(character) && text.size() - at >= 4)
    {
      const std::uint32_t low = UnitAt(encoding, text, at + 2);
      if (!IsLowSurrogate(low))
      {
        ThrowBroken(encoding, at);
      }
      character = 0x10000 + ((character - 0xD800) << 10) + (low - 0xDC00);
      at += encoding.Unit;
    }
    if (character > 0x10FFFF || IsHighSurrogate(character) || IsLowSurrogate(character))
    {
      ThrowBroken(encoding, at);
    }
    utf8::unchecked::append(character, std::back_inserter(utf8));
  }
  return utf8;
}
}

//------------------------------------------------------------------------------
bool HasWideMark(const FileBytes& bytes)
{
  return EncodingOf(View(bytes)) != nullptr;
}

//------------------------------------------------------------------------------
FileBytes ToUtf8(FileBytes bytes)
{
  const Encoding* const encoding = EncodingOf(View(bytes));
  return encoding ? FileBytes::Copy(Decode(*encoding, View(bytes))) : std::move(bytes);
}
}
