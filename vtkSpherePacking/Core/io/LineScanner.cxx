// SPDX-License-Identifier: BSD-3-Clause
#include "io/LineScanner.h"

#include "io/Number.h"
#include "io/PackingFileError.h"

#include <algorithm>
#include <cmath>

namespace spherepacking
{
//------------------------------------------------------------------------------
LineScanner::LineScanner(const TextRange& text, std::string_view comment)
  : Comment(comment)
  , End(text.End)
  , Find(text.End)
  , After(text.Begin)
  , AfterNumber(text.FirstLine)
  , Number(text.FirstLine)
{
}

//------------------------------------------------------------------------------
bool LineScanner::Next()
{
  while (this->After != this->End)
  {
    const char* const end = this->Find(this->After);
    const char* const begin = SkipBlanks(this->After, end);
    std::string_view line(begin, end - begin);
    if (!this->Comment.empty())
    {
      line = line.substr(0, line.find(this->Comment));
    }
    while (!line.empty() && IsBlank(line.back()))
    {
      line.remove_suffix(1);
    }
    this->Whole = std::string_view(this->After, end - this->After);
    this->After = SkipLineEnd(end, this->End);
    ++this->AfterNumber;
    if (!line.empty())
    {
      this->Current = line;
      this->Number = this->AfterNumber - 1;
      return true;
    }
  }
  return false;
}

//------------------------------------------------------------------------------
void LineScanner::Require(const std::string& expected, const std::string& found)
{
  if (!this->Next())
  {
    const char* const line = this->Current.data();
    throw LineError(this->Number,
      "found the end of the file after " +
        (found.empty() ? Quote(line, line + this->Current.size()) : found) + ", expected " +
        expected);
  }
}

//------------------------------------------------------------------------------
void LineScanner::MoveTo(const TextRange& text)
{
  this->After = text.Begin;
  this->AfterNumber = text.FirstLine;
}

//------------------------------------------------------------------------------
std::vector<std::string_view> LineScanner::Fields() const
{
  std::vector<std::string_view> fields;
  const auto separates = [](char c) { return IsBlank(c) || c == ',' || c == ';'; };
  const char* const end = this->Current.data() + this->Current.size();
  for (const char* p = this->Current.data();;)
  {
    p = std::find_if_not(p, end, separates);
    if (p == end)
    {
      break;
    }
    const char* const next = std::find_if(p, end, separates);
    fields.emplace_back(p, next - p);
    p = next;
  }
  if (fields.empty())
  {
    fields.push_back(this->Current);
  }
  return fields;
}

//------------------------------------------------------------------------------
std::vector<double> LineScanner::Numbers(std::size_t count, const std::string& expected) const
{
  const auto fields = this->Fields();
  std::vector<double> numbers(fields.size());
  bool good = fields.size() == count;
  for (std::size_t i = 0; good && i < count; ++i)
  {
    good = ParseFinite(fields[i], numbers[i]);
  }
  if (!good)
  {
    this->Refuse(expected);
  }
  return numbers;
}

//------------------------------------------------------------------------------
vtkIdType LineScanner::Count(const std::string& expected) const
{
  const double count = this->Numbers(1, expected)[0];
  if (!IsCount(count))
  {
    this->Refuse(expected + ", a whole number that is not negative");
  }
  return static_cast<vtkIdType>(count);
}

//------------------------------------------------------------------------------
void LineScanner::Refuse(const std::string& expected) const
{
  const char* const line = this->Current.data();
  throw LineError(
    this->Number, "found " + Quote(line, line + this->Current.size()) + ", expected " + expected);
}

//------------------------------------------------------------------------------
bool ParseFinite(std::string_view field, double& value)
{
  const char* const end = field.data() + field.size();
  return ParseNumber(field.data(), end, value) == end && std::isfinite(value);
}
}
