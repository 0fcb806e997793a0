// SPDX-License-Identifier: BSD-3-Clause
#include "io/TimeStepCache.h"

#include "io/FileBytes.h"

#include "vtksys/SystemTools.hxx"

namespace spherepacking
{
//------------------------------------------------------------------------------
const TimeSteps& TimeStepCache::Find(Format format, const std::string& file)
{
  const unsigned long long size = FileBytes::Size(file);
  const long modified = vtksys::SystemTools::ModifiedTime(file);
  if (!this->Steps || format != this->FormatOfFile || file != this->File || size != this->Size ||
    modified != this->ModifiedTime)
  {
    this->Steps.reset();
    this->Steps.emplace(format == Format::Dump ? FindDumpSteps(file)
        : format == Format::Xyz                ? FindXyzSteps(file)
                                               : FindMercurySteps(file));
    this->FormatOfFile = format;
    this->File = file;
    this->Size = size;
    this->ModifiedTime = modified;
  }
  return *this->Steps;
}
}
