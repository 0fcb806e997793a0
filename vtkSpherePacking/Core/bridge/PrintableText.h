// SPDX-License-Identifier: BSD-3-Clause
#ifndef PrintableText_h
#define PrintableText_h

#include <cstddef>
#include <string>
#include <string_view>

namespace spherepacking
{
/// `bytes` as UTF-8 for people and for Python: what is no character, or has no shape and may change
/// how others look, is written \xNN, and a tab is a blank. After `longest` characters it ends in
/// three points.
std::string PrintableText(std::string_view bytes, std::size_t longest = std::string_view::npos);

/// An error's sentence the same way, without its middle if it is longer than 1000 bytes: the names
/// of files, arrays and columns in it are whatever somebody has called them.
std::string PrintableSentence(std::string_view sentence);
}

#endif
