// SPDX-License-Identifier: BSD-3-Clause
#ifndef TimeStepCache_h
#define TimeStepCache_h

#include "io/TimeSteps.h"

#include <array>

namespace spherepacking
{
/**
 * Caches the time steps of a file, so that an animation does not scan the whole file again, as long
 * as its format, its name and what the system says of it stay the same.
 */
class TimeStepCache
{
public:
  /// The steps of `file`, from the cache if they are there.
  const TimeSteps& Find(Format format, const std::string& file, Progress& progress);

  /// How often the file was searched: as long as it stays the same, so do the steps.
  int Searches() const { return this->SearchCount; }

private:
  /// Device, number of the inode, size, and seconds and nanoseconds of the last modification of
  /// content and inode, which a program may not set.
  using Stamp = std::array<long long, 7>;

  static Stamp StampOf(const std::string& file);

  Format FormatOfFile = Format::Auto;
  std::string File;
  Stamp StampOfFile{};
  bool IsSettled = false; ///< whether a later change would have another stamp
  std::optional<TimeSteps> Steps;
  int SearchCount = 0;
};
}

#endif
