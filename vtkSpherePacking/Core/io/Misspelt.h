// SPDX-License-Identifier: BSD-3-Clause
#ifndef Misspelt_h
#define Misspelt_h

#include <cstddef>
#include <string_view>

namespace spherepacking
{
/// Whether `found` is `word` with one wrong letter, as in a damaged file.
inline bool IsMisspelt(std::string_view found, std::string_view word)
{
  int wrong = 0;
  for (std::size_t i = 0; found.size() == word.size() && i < word.size(); ++i)
  {
    wrong += found[i] != word[i];
  }
  return wrong == 1;
}
}

#endif
