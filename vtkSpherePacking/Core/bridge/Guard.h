// SPDX-License-Identifier: BSD-3-Clause
/// The one place where exceptions of this module become errors of a VTK algorithm.
#ifndef Guard_h
#define Guard_h

#include "base/FunctionRef.h"

#include <chrono>
#include <sstream>
#include <stdexcept>
#include <string>

class vtkAlgorithm;

namespace spherepacking
{
/// An error with a code of vtkErrorCode. Any other exception has the code UserError.
class CodedError : public std::runtime_error
{
public:
  CodedError(unsigned long code, const std::string& message)
    : std::runtime_error(message)
    , Code(code)
  {
  }

  unsigned long Code;
};

/// Thrown where a request to abort was seen. Not an error: whoever asked knows.
struct AbortRequest
{
};

enum class Outcome
{
  Done,
  Failed,
  Aborted
};

/// When an error is reported through vtkErrorMacro: at once, or by a later request, which will meet
/// the same error.
enum class Report
{
  Now,
  Later
};

/// Runs `work` so that no exception leaves it: VTK's Python wrappers do not translate any, so one
/// would end the process. The sentence of an exception, or that of `outOfMemory` for a
/// std::bad_alloc, becomes `message`, goes to vtkErrorMacro of the algorithm, and sets its error
/// code; otherwise the message is empty and there is no error code.
Outcome RunGuarded(vtkAlgorithm* algorithm, std::string& message,
  FunctionRef<std::string()> outOfMemory, FunctionRef<void()> work, Report report = Report::Now);

/// Throws the std::invalid_argument "NAME: found FOUND, expected EXPECTED".
template <typename Value>
[[noreturn]] void Refuse(const std::string& name, const Value& found, const std::string& expected)
{
  std::ostringstream message;
  message << name << ": found " << found << ", expected " << expected;
  throw std::invalid_argument(message.str());
}

/// Values with a blank between them, as they stand in such a sentence.
template <typename Value>
std::string Join(const Value* values, int count)
{
  std::ostringstream text;
  for (int i = 0; i < count; ++i)
  {
    text << (i > 0 ? " " : "") << values[i];
  }
  return text.str();
}

/// Measures time from its construction on.
class Stopwatch
{
public:
  double Seconds() const
  {
    return std::chrono::duration<double>(std::chrono::steady_clock::now() - this->Start).count();
  }

private:
  std::chrono::steady_clock::time_point Start = std::chrono::steady_clock::now();
};
}

#endif
