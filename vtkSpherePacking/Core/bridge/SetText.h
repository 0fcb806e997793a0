// SPDX-License-Identifier: BSD-3-Clause
#ifndef SetText_h
#define SetText_h

#include <cstring>
#include <new>

namespace spherepacking
{
/// Makes `text` a copy of `value`, or null for null; returns whether that changes it. In contrast
/// to vtkSetStringMacro it lets no std::bad_alloc leave the setter: `lost` says whether there was
/// no memory for the copy, and whoever needs the text is to say so.
inline bool SetText(char*& text, const char* value, bool& lost)
{
  if (!lost && (text && value ? std::strcmp(text, value) == 0 : text == value))
  {
    return false;
  }
  delete[] text;
  text = nullptr;
  lost = false;
  if (value)
  {
    const std::size_t size = std::strlen(value) + 1;
    text = new (std::nothrow) char[size];
    lost = !text;
    if (text)
    {
      std::memcpy(text, value, size);
    }
  }
  return true;
}
}

#endif
