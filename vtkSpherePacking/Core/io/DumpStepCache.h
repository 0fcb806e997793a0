// SPDX-License-Identifier: BSD-3-Clause
#ifndef DumpStepCache_h
#define DumpStepCache_h

#include "io/DumpFile.h"

#include <optional>

namespace spherepacking
{
/**
 * Keeps where the steps of a dump lie, so that moving through time does not walk over the whole
 * file again, as long as its name, size and time of change stay the same.
 */
class DumpStepCache
{
public:
  const std::vector<DumpStep>& Find(const std::string& file);

  /// The last of the steps of `file` that is not after `time`; the first when all are, and
  /// without a time.
  const DumpStep& Choose(const std::string& file, const std::optional<double>& time);

private:
  std::string File;
  unsigned long long Size = 0;
  long Changed = 0;
  std::vector<DumpStep> Steps;
};
}

#endif
