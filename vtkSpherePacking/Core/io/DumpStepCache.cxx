// SPDX-License-Identifier: BSD-3-Clause
#include "io/DumpStepCache.h"

#include "io/FileBytes.h"

#include "vtksys/SystemTools.hxx"

namespace spherepacking
{
//------------------------------------------------------------------------------
const std::vector<DumpStep>& DumpStepCache::Find(const std::string& file)
{
  const unsigned long long size = FileBytes::Size(file);
  const long modified = vtksys::SystemTools::ModifiedTime(file);
  if (this->Steps.empty() || file != this->File || size != this->Size ||
    modified != this->ModifiedTime)
  {
    this->Steps.clear();
    this->Steps = FindDumpSteps(file);
    this->File = file;
    this->Size = size;
    this->ModifiedTime = modified;
  }
  return this->Steps;
}

//------------------------------------------------------------------------------
const DumpStep& DumpStepCache::Choose(const std::string& file, const std::optional<double>& time)
{
  const std::vector<DumpStep>& steps = this->Find(file);
  const DumpStep* chosen = &steps.front();
  for (const DumpStep& step : steps)
  {
    if (time && step.Time <= *time)
    {
      chosen = &step;
    }
  }
  return *chosen;
}
}
