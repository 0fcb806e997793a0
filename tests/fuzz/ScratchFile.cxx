// SPDX-License-Identifier: BSD-3-Clause
#include "ScratchFile.h"

#include <cstdio>
#include <cstdlib>
#include <sys/stat.h>
#include <unistd.h>

//------------------------------------------------------------------------------
std::string ScratchPath(const std::string& extension)
{
  static const std::string folder = []
  {
    const bool memory = access("/dev/shm", W_OK) == 0;
    const std::string path =
      std::string(memory ? "/dev/shm" : "/tmp") + "/spherepacking-fuzz-" + std::to_string(getpid());
    mkdir(path.c_str(), 0700);
    return path;
  }();
  return folder + "/packing" + extension;
}

//------------------------------------------------------------------------------
void WriteScratch(const std::string& path, const std::uint8_t* bytes, std::size_t count)
{
  std::FILE* const file = std::fopen(path.c_str(), "wb");
  if (!file || std::fwrite(bytes, 1, count, file) != count || std::fclose(file) != 0)
  {
    std::perror(path.c_str());
    std::abort();
  }
}
