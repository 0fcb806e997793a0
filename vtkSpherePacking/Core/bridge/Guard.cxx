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
}

//------------------------------------------------------------------------------
Outcome RunGuarded(vtkAlgorithm* algorithm, std::string& message,
  FunctionRef<std::string()> outOfMemory, FunctionRef<void()> work, Report report)
{
  message.clear();
  unsigned long code = vtkErrorCode::NoError;
  Outcome outcome = Outcome::Failed;
  try
  {
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
      code = vtkErrorCode::UserError;
      message = PrintableSentence(outOfMemory());
    }
    catch (const CodedError& error)
    {
      code = error.Code;
      message = PrintableSentence(error.what());
    }
    catch (const std::exception& error)
    {
      code = vtkErrorCode::UserError;
      message = PrintableSentence(error.what());
    }
  }
  catch (const std::bad_alloc&)
  {
    // Not even the sentence; this one is short enough for a std::string to hold it itself.
    message = "out of memory";
  }
  ErrorCodeOf::Set(algorithm, code);
  if (outcome == Outcome::Failed && report == Report::Now)
  {
    try
    {
      vtkErrorWithObjectMacro(algorithm, << message);
    }
    catch (const std::bad_alloc&)
    {
      // VTK cannot print it; the message and the code are there for whoever asks.
    }
  }
  return outcome;
}
}
