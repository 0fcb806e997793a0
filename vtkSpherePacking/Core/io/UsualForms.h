// SPDX-License-Identifier: BSD-3-Clause
#ifndef UsualForms_h
#define UsualForms_h

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

namespace spherepacking
{
/**
 * What a line says in forms that FitNames reads, with the names of `count` columns between blanks
 * or commas, if it may list them in another: all in one pair of brackets or quotes, "[x, y, z, d]",
 * some in brackets, "(x y z) (d)", between rules, dashes or the like, "x | y | z | d", or as one
 * word, "xyzd".
 */
std::vector<std::string> UsualForms(std::string_view line, std::size_t count);
}

#endif
