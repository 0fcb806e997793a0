// SPDX-License-Identifier: BSD-3-Clause
#include "io/PqrRemarks.h"

#include "io/PdbRecord.h"

#include <algorithm>
#include <charconv>
#include <string>

namespace spherepacking
{
namespace
{
// The first number after the word column in a remark that speaks of `what`, or 0.
int ColumnOf(const std::string& remark, const char* what)
{
  std::size_t at = remark.find(what);
  at = at == remark.npos ? at : remark.find("column", at);
  at = at == remark.npos ? at : remark.find_first_of("0123456789", at);
  int column = 0;
  if (at != remark.npos)
  {
    std::from_chars(remark.data() + at, remark.data() + remark.size(), column);
  }
  return column;
}

// Calls `see` for each remark before the first atom, in lower case.
template <typename See>
void ForEachRemark(const TextRange& text, const See& see)
{
  LineFinder find(text.End);
  for (const char* p = text.Begin; p != text.End;)
  {
    const char* const end = find(p);
    if (IsAtomRecord(p, end))
    {
      break;
    }
    if (BeginsWithRecord(p, end, "REMARK"))
    {
      std::string remark(p, end);
      std::transform(remark.begin(), remark.end(), remark.begin(),
        [](char c) { return c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c; });
      see(remark);
    }
    p = SkipLineEnd(end, text.End);
  }
}
}

//------------------------------------------------------------------------------
bool SaysRadiusFirst(const TextRange& text)
{
  int radius = 0;
  int charge = 0;
  ForEachRemark(text,
    [&](const std::string& remark)
    {
      radius = std::max(radius, ColumnOf(remark, "radi"));
      charge = std::max(charge, ColumnOf(remark, "charge"));
    });
  return radius > 0 && radius < charge;
}

//------------------------------------------------------------------------------
bool SaysRadiiInBFactors(const TextRange& text)
{
  bool says = false;
  ForEachRemark(text,
    [&](const std::string& remark)
    {
      says = says || (remark.find("b-factor") != remark.npos && remark.find("radi") != remark.npos);
    });
  return says;
}
}
