// SPDX-License-Identifier: BSD-3-Clause
#ifndef LineCursor_h
#define LineCursor_h

#include "io/Number.h"
#include "io/PackingFileError.h"
#include "io/Separators.h"
#include "io/TextLines.h"

#include <cmath>
#include <string>
#include <string_view>
#include <vector>

namespace spherepacking
{
/// Goes through the lines of a header in order.
class LineCursor
{
public:
  explicit LineCursor(const TextRange& text)
    : End(text.End)
    , Find(text.End)
    , Next(text.Begin)
    , NextNumber(text.FirstLine)
  {
  }

  /// Moves on to the next line, the first at first; false if there is none.
  bool Step()
  {
    if (this->Next == this->End)
    {
      return false;
    }
    const char* const end = this->Find(this->Next);
    this->Current = std::string_view(this->Next, end - this->Next);
    this->HasNoLineEnd = end == this->End;
    this->Next = SkipLineEnd(end, this->End);
    ++this->NextNumber;
    return true;
  }

  /// Moves on, or throws: "found the end of WHAT, expected EXPECTED".
  void StepInto(const char* what, const std::string& expected)
  {
    if (!this->Step())
    {
      throw LineError(
        this->Number(), std::string("found the end of ") + what + ", expected " + expected);
    }
  }

  /// The current line without its end, and its number.
  std::string_view Line() const { return this->Current; }
  vtkIdType Number() const { return this->NextNumber - 1; }

  /// Whether the current line ends with the text rather than with a line end.
  bool EndsWithText() const { return this->HasNoLineEnd; }

  /// The lines after the current one.
  TextRange Rest() const { return { this->Next, this->End, this->NextNumber }; }

  std::string Quoted() const
  {
    return Quote(this->Current.data(), this->Current.data() + this->Current.size());
  }

  /// Throws "found 'LINE', expected EXPECTED".
  [[noreturn]] void Refuse(const std::string& expected) const
  {
    throw LineError(this->Number(), "found " + this->Quoted() + ", expected " + expected);
  }

  std::vector<std::string_view> Fields() const
  {
    return Separators::Blanks().Split(this->Current.data());
  }

  /// The finite numbers of which the line consists; throws if it holds anything else.
  std::vector<double> Numbers(const std::string& expected) const
  {
    std::vector<double> numbers;
    for (const std::string_view field : this->Fields())
    {
      double value;
      const char* const end = field.data() + field.size();
      if (ParseNumber(field.data(), end, value) != end || !std::isfinite(value))
      {
        this->Refuse(expected);
      }
      numbers.push_back(value);
    }
    return numbers;
  }

  /// The count of which the line consists; throws if it is anything else.
  vtkIdType Count(const std::string& expected) const
  {
    const std::vector<double> numbers = this->Numbers(expected);
    if (numbers.size() != 1 || !IsCount(numbers[0]))
    {
      this->Refuse(expected);
    }
    return static_cast<vtkIdType>(numbers[0]);
  }

private:
  const char* End;
  LineFinder Find;
  const char* Next;
  vtkIdType NextNumber;
  std::string_view Current;
  bool HasNoLineEnd = false;
};
}

#endif
