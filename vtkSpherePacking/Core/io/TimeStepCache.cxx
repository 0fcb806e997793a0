// SPDX-License-Identifier: BSD-3-Clause
#include "io/TimeStepCache.h"

#include "io/FileBytes.h"

#include <sys/stat.h>

#include <chrono>

namespace spherepacking
{
namespace
{
// A file that was written so recently may be written again without another time, which comes from a
// clock that ticks every few milliseconds, on other machines' disks less often.
constexpr double SettlingSeconds = 2.0;

double SecondsSince(long long seconds, long long nanoseconds)
{
  const auto now = std::chrono::system_clock::now().time_since_epoch();
  return std::chrono::duration<double>(
    now - std::chrono::seconds(seconds) - std::chrono::nanoseconds(nanoseconds))
    .count();
}
}

//------------------------------------------------------------------------------
TimeStepCache::Stamp TimeStepCache::StampOf(const std::string& file)
{
  struct stat status{};
  stat(file.c_str(), &status);
  return { static_cast<long long>(status.st_dev), static_cast<long long>(status.st_ino),
    static_cast<long long>(status.st_size), status.st_mtim.tv_sec, status.st_mtim.tv_nsec,
    status.st_ctim.tv_sec, status.st_ctim.tv_nsec };
}

//------------------------------------------------------------------------------
const TimeSteps& TimeStepCache::Find(Format format, const std::string& file, Progress& progress)
{
  FileBytes::Size(file); // throws if it cannot be read
  const Stamp stamp = StampOf(file);
  if (!this->Steps || format != this->FormatOfFile || file != this->File ||
    stamp != this->StampOfFile || !this->IsSettled)
  {
    this->Steps.reset();
    this->IsSettled = SecondsSince(stamp[5], stamp[6]) > SettlingSeconds;
    this->Steps.emplace(format == Format::Dump ? FindDumpSteps(file, progress)
        : format == Format::Xyz                ? FindXyzSteps(file, progress)
                                               : FindMercurySteps(file, progress));
    ++this->SearchCount;
    this->FormatOfFile = format;
    this->File = file;
    this->StampOfFile = stamp;
  }
  return *this->Steps;
}
}
