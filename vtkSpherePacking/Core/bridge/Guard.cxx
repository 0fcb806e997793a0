// SPDX-License-Identifier: BSD-3-Clause
#include "bridge/Guard.h"

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
    message = outOfMemory;
    code = vtkErrorCode::UserError;
  }
  catch (const CodedError& error)
  {
    message = error.what();
    code = error.Code;
  }
  catch (const std::exception& error)
  {
    message = error.what();
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
