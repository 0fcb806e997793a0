// SPDX-License-Identifier: BSD-3-Clause
#ifndef ScratchFile_h
#define ScratchFile_h

#include <cstddef>
#include <cstdint>
#include <string>

/// Where the files of this process lie: in memory where there is such a folder, else in /tmp.
std::string ScratchPath(const std::string& extension);

/// Makes the file hold these bytes.
void WriteScratch(const std::string& path, const std::uint8_t* bytes, std::size_t count);

#endif
