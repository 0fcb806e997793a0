// SPDX-License-Identifier: BSD-3-Clause
#ifndef DumpStepCache_h
#define DumpStepCache_h

#include "io/DumpFile.h"

#include <optional>

namespace spherepacking
{
/**
 * Caches the time steps of a dump, so that an animation does not scan the whole file again, as long
 * as its name, size and time of modification stay the same.
 */
class DumpStepCache
{
public:
  /// The steps of `file`, from the cache if they are there.
  const std::vector<DumpStep>& Find(const std::string& file);

  /// The last step of `file` that is not after `time`; the first if all are, or without a time.
  const DumpStep& Choose(const std::string& file, const std::optional<double>& time);

private:
  std::string File;
  unsigned long long Size = 0;
  long ModifiedTime = 0;
  std::vector<DumpStep> Steps;
};
}

#endif
