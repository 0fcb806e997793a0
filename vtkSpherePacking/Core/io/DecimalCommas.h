// SPDX-License-Identifier: BSD-3-Clause
#ifndef DecimalCommas_h
#define DecimalCommas_h

#include <string_view>

namespace spherepacking
{
/// Whether a row has commas right between digits, as in 1,5 for one and a half, besides other
/// separators and no point. Taken for separators they would make two numbers of each.
bool HasDecimalCommas(std::string_view row);

/// Whether a field is a number with a comma in place of the point: -1,5e3.
bool IsDecimalComma(std::string_view field);
}

#endif
