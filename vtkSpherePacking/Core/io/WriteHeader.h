// SPDX-License-Identifier: BSD-3-Clause
#ifndef WriteHeader_h
#define WriteHeader_h

#include "io/WrittenColumns.h"

#include <string>
#include <vector>

namespace spherepacking
{
/// The lines of the file before the spheres; none in most formats.
std::string HeaderOf(const WriteOptions& options, const std::vector<WrittenArray>& arrays);
}

#endif
