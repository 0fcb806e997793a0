// SPDX-License-Identifier: BSD-3-Clause
#include "bridge/Guard.h"

#include "bridge/PrintableText.h"

#include "vtkAlgorithm.h"
#include "vtkErrorCode.h"

#include <new>

namespace spherepacking
{
namespace
{
// The setter is protected, and each class would otherwise need a function that calls it.
struct ErrorCodeOf : vtkAlgorithm
{
  static void Set(vtkAlgorithm* algorithm, unsigned long code)
  {
    (algorithm->*(&ErrorCodeOf::SetErrorCode))(code);
  }
};

// A sentence as it may be shown. It has names of files and arrays in it.
std::string Shown(const char* sentence)
{
  try
  {
    return PrintableSentence(sentence);
  }
  catch (const std::bad_alloc&)
  {
    return "out of memory"; // so short that it needs none
  }
}
}

//------------------------------------------------------------------------------
Outcome RunGuarded(vtkAlgorithm* algorithm, std::string& message, const std::string& outOfMemory,
  const std::function<void()>& work, Report report)
{
  message.clear();
  unsigned long code = vtkErrorCode::NoError;
  Outcome outcome = Outcome::Failed;
  try
  {
    work();
    outcome = Outcome::Done;
  }
  catch (const AbortRequest&)
  {
    outcome = Outcome::Aborted;
  }
  catch (const std::bad_alloc&)
  {
    message = Shown(outOfMemory.c_str());
    code = vtkErrorCode::UserError;
  }
  catch (const CodedError& error)
  {
    message = Shown(error.what());
    code = error.Code;
  }
  catch (const std::exception& error)
  {
    message = Shown(error.what());
    code = vtkErrorCode::UserError;
  }
  ErrorCodeOf::Set(algorithm, code);
  if (outcome == Outcome::Failed && report == Report::Now)
  {
    vtkErrorWithObjectMacro(algorithm, << message);
  }
  return outcome;
}
}
