// SPDX-License-Identifier: BSD-3-Clause
/// Errors of files. What parses or makes the content of a file does not know which file it is and
/// throws a ContentError; the one function of a format that opens the file adds its name.
#ifndef PackingFileError_h
#define PackingFileError_h

#include "bridge/Guard.h"

#include <stdexcept>
#include <string>
#include <string_view>

namespace spherepacking
{
/// Why a file cannot be read or written: a sentence that names the file, what was found and what
/// was expected, with its vtkErrorCode. Thrown only in the thread that runs the algorithm, since
/// worker threads report by value.
class PackingFileError : public CodedError
{
public:
  using CodedError::CodedError;
};

/// What is wrong with the content of a file, and where in it if that is known.
class ContentError : public std::runtime_error
{
public:
  explicit ContentError(const std::string& what, const std::string& location = {})
    : std::runtime_error(what)
    , Location(location)
  {
  }

  std::string Location; ///< such as "line 3", or empty
};

/// What is wrong with a line of a text.
class LineError : public ContentError
{
public:
  LineError(long long line, const std::string& what)
    : ContentError(what, "line " + std::to_string(line))
    , Line(line)
  {
  }

  long long Line;
};

/// Throws the PackingFileError "FILE, LOCATION: WHAT".
[[noreturn]] void ThrowInFile(const std::string& file, const ContentError& error);

/// Returns work(), and names the file in a ContentError that leaves it.
template <typename Work>
auto WithFileName(const std::string& file, const Work& work)
{
  try
  {
    return work();
  }
  catch (const ContentError& error)
  {
    ThrowInFile(file, error);
  }
}

/// The bytes [begin, end) in single quotes, clipped, and unprintable ones as \xNN.
std::string Quote(const char* begin, const char* end);
}

#endif
