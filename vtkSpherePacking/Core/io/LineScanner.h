// SPDX-License-Identifier: BSD-3-Clause
#ifndef LineScanner_h
#define LineScanner_h

#include "io/TextLines.h"

#include <charconv>
#include <string>
#include <string_view>
#include <system_error>
#include <vector>

namespace spherepacking
{
/**
 * Goes through the lines of a text that hold something, for formats whose lines have meanings by
 * their order. Blank lines and comments are passed over.
 */
class LineScanner
{
public:
  /// `comment` begins a comment, which ends with its line; empty if the format has none.
  explicit LineScanner(const TextRange& text, std::string_view comment = "#");

  /// Moves on to the next line that holds something; false if there is none.
  bool Next();

  /// The same; throws "found the end of the file after FOUND, expected EXPECTED", where `found` is
  /// the line before if it is empty.
  void Require(const std::string& expected, const std::string& found = {});

  /// The current line, without a comment and blanks around.
  std::string_view Line() const { return this->Current; }

  /// The same with comment and blanks, for formats in columns.
  std::string_view WholeLine() const { return this->Whole; }

  vtkIdType LineNumber() const { return this->Number; }

  /// What follows the current line, or the whole text before the first Next().
  TextRange Rest() const { return { this->After, this->End, this->AfterNumber }; }

  /// Goes on at `text`, which must lie behind the current line.
  void MoveTo(const TextRange& text);

  /// The fields of the current line, which blanks, commas or semicolons separate; at least
  /// one.
  std::vector<std::string_view> Fields() const;

  /// The numbers of the current line, which must be `count`, finite and all that is there.
  std::vector<double> Numbers(std::size_t count, const std::string& expected) const;

  /// The number of the current line, which must be a count and all that is there.
  vtkIdType Count(const std::string& expected) const;

  /// Throws "found LINE, expected EXPECTED" about the current line.
  [[noreturn]] void Refuse(const std::string& expected) const;

private:
  std::string_view Comment;
  const char* End;
  LineFinder Find;
  const char* After;
  vtkIdType AfterNumber;
  std::string_view Whole;
  std::string_view Current;
  vtkIdType Number;
};

/// Whether all of `field` is a finite number; sets `value`.
bool ParseFinite(std::string_view field, double& value);

/// Whether all of `field` is a whole number in the range of `value`, which it sets.
template <typename Integer>
bool ParseInteger(std::string_view field, Integer& value)
{
  const char* const end = field.data() + field.size();
  const auto result = std::from_chars(field.data(), end, value);
  return result.ec == std::errc() && result.ptr == end;
}
}

#endif
