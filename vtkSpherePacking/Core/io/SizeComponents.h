// SPDX-License-Identifier: BSD-3-Clause
#ifndef SizeComponents_h
#define SizeComponents_h

#include "io/Separators.h"
#include "io/TextLines.h"

#include <cstddef>
#include <optional>
#include <string_view>
#include <vector>

namespace spherepacking
{
/// Where three columns such as radius_0, radius_1, radius_2 begin, as ParaView writes a radius of
/// three components, if no other name is that of a size.
std::optional<std::size_t> FindSizeComponents(const std::vector<std::string_view>& names);

/// Throws if the three columns from `first` on are not equal in a row.
void CheckSizeComponents(const TextRange& rows, const Separators& between, std::size_t first);
}

#endif
