// SPDX-License-Identifier: BSD-3-Clause
#ifndef NameBrackets_h
#define NameBrackets_h

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

namespace spherepacking
{
/// A bracket of a line of names, and what stands before it.
struct NameBracket
{
  std::string_view Name;  ///< the word before it, if one stands right before it
  std::string_view Text;  ///< what is in it
  std::size_t Before = 0; ///< where what stands before it ends
  std::size_t End = 0;    ///< behind its closing half
};

/// The brackets (...) and [...] of `line`, up to one that does not close.
std::vector<NameBracket> FindBrackets(std::string_view line);

/// Whether what is in a bracket says only of what a size is, or in which unit that we do not know:
/// "equivalent", "-", "LJ units".
bool IsPlainBracket(std::string_view text);

/// Whether what is in a bracket says that a number is no length: "log10", "squared", "%".
bool IsNoLength(std::string_view text);

/// Whether what is in a bracket says that a number is a length times another number: "x1000",
/// "10^-3 m".
bool IsScaled(std::string_view text);

/// The bracket in a line of names because of which numbers may be no lengths, or lengths of another
/// unit than those of the other columns; empty if there is none.
std::string_view FindUnclearBracket(std::string_view line);
}

#endif
