// SPDX-License-Identifier: BSD-3-Clause
#include "io/RemarkWords.h"

#include <algorithm>
#include <utility>

namespace spherepacking
{
namespace
{
bool IsUpper(char c)
{
  return c >= 'A' && c <= 'Z';
}

bool IsDigit(char c)
{
  return c >= '0' && c <= '9';
}

// Where the character at `p` ends if it is punctuation or a sign beyond ASCII, else `p`. The sign
// for diameters and the apostrophe of typesetters are parts of words.
std::size_t SignEnd(std::string_view text, std::size_t p)
{
  const auto byte = [&](std::size_t i)
  { return i < text.size() ? static_cast<unsigned char>(text[i]) : 0U; };
  const std::string_view three = text.substr(p, 3);
  if (three == "\xE2\x8C\x80" || three == "\xE2\x80\x99")
  {
    return p;
  }
  const unsigned first = byte(p);
  const unsigned second = byte(p + 1);
  const bool ofTwo = (first == 0xC2 && second >= 0xA0 && second != 0xB5) ||
    (first == 0xC3 && (second == 0x97 || second == 0xB7));
  const bool ofThree = (first == 0xE2 && second >= 0x80 && second <= 0xAF) ||
    (first == 0xE3 && second == 0x80) || (first == 0xEF && second == 0xBC && byte(p + 2) <= 0x8F);
  return std::min(p + (ofTwo ? 2 : ofThree ? 3 : 0), text.size());
}

// Where a word that begins at `p` ends.
std::size_t WordEnd(std::string_view text, std::size_t p)
{
  const auto isOfWord = [&](char c)
  { return IsUpper(c) || IsDigit(c) || (c >= 'a' && c <= 'z') || c == '\'' || c < 0; };
  while (p < text.size() && isOfWord(text[p]) && SignEnd(text, p) == p)
  {
    ++p;
  }
  return p;
}
}

//------------------------------------------------------------------------------
std::vector<RemarkWord> SplitRemark(std::string_view text)
{
  std::vector<RemarkWord> words;
  for (std::size_t p = 0; p < text.size();)
  {
    RemarkWord word{ p, WordEnd(text, p), {} };
    if (word.End == p)
    {
      p = std::max(SignEnd(text, p), p + 1);
      continue;
    }
    p = word.End;
    if (text[word.Begin] == '\'') // a quote
    {
      word.Begin = std::min(text.find_first_not_of('\'', word.Begin), word.End);
      while (word.End > word.Begin && text[word.End - 1] == '\'')
      {
        --word.End;
      }
    }
    for (std::size_t i = word.Begin; i < word.End; ++i)
    {
      word.Lower += IsUpper(text[i]) ? static_cast<char>(text[i] - 'A' + 'a') : text[i];
    }
    if (!word.Lower.empty())
    {
      words.push_back(std::move(word));
    }
  }
  return words;
}
}
