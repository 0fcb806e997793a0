// SPDX-License-Identifier: BSD-3-Clause
#ifndef TimeStepCache_h
#define TimeStepCache_h

#include "io/TimeSteps.h"

namespace spherepacking
{
/**
 * Caches the time steps of a file, so that an animation does not scan the whole file again, as long
 * as its format, name, size and time of modification stay the same.
 */
class TimeStepCache
{
public:
  /// The steps of `file`, from the cache if they are there.
  const TimeSteps& Find(Format format, const std::string& file);

private:
  Format FormatOfFile = Format::Auto;
  std::string File;
  unsigned long long Size = 0;
  long ModifiedTime = 0;
  std::optional<TimeSteps> Steps;
};
}

#endif
