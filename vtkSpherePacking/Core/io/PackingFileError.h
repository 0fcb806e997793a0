// SPDX-License-Identifier: BSD-3-Clause
#ifndef PackingFileError_h
#define PackingFileError_h

#include "bridge/Guard.h"

#include <string>

namespace spherepacking
{
/**
 * Why a file cannot be read or written: one sentence that names the file, what was found and what
 * was expected, with its vtkErrorCode. Thrown only in the thread that runs the algorithm, which
 * turns it into vtkErrorMacro; worker threads report by value.
 */
class PackingFileError : public CodedError
{
public:
  using CodedError::CodedError;
};

/// A format error in a line of a file: "FILE, line N: WHAT".
[[noreturn]] void ThrowAtLine(const std::string& file, long long line, const std::string& what);

/// The bytes [begin, end) in single quotes, clipped, unprintable ones as \xNN.
std::string Quote(const char* begin, const char* end);
}

#endif
