// SPDX-License-Identifier: BSD-3-Clause
#ifndef SplitNames_h
#define SplitNames_h

#include <cstddef>
#include <string_view>
#include <vector>

namespace spherepacking
{
/// What stands between names in a line.
enum class Between
{
  Anything, // blanks, commas and semicolons
  Commas,   // or semicolons
  Tabs,
  WideGaps // two blanks or more, or a tab
};

/// The text without blanks and tabs at its ends.
std::string_view Trim(std::string_view text);

/// Where the bracket that opens at `at` closes, or `at` if it does not.
std::size_t BracketEnd(std::string_view line, std::size_t at);

/// Splits a line, but not within brackets. Between blanks, brackets are units and left out.
std::vector<std::string_view> SplitNames(std::string_view line, Between between);

/// The line without the signs that begin a comment here or elsewhere.
std::string_view WithoutSigns(std::string_view line);

/// The line without a word that says that names follow, such as "columns:", but not "id: x: y:".
std::string_view WithoutLabel(std::string_view line);

/// The same where the word may be a name, too. #C does so in files of IMD.
std::string_view WithoutLabelWord(std::string_view line);
}

#endif
