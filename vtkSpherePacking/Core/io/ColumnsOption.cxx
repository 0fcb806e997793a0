// SPDX-License-Identifier: BSD-3-Clause
#include "io/ColumnsOption.h"

#include "io/PackingFileError.h"

namespace spherepacking
{
//------------------------------------------------------------------------------
std::optional<std::vector<Column>> ColumnsOfOption(const ReadOptions& options)
{
  const std::string line = options.Columns + '\n';
  const auto names = Separators::Liberal().Split(line.data());
  if (names.empty())
  {
    return std::nullopt;
  }
  std::string complaint;
  auto columns = ColumnsFromNames(names, complaint, RadiiOf(options));
  if (!columns)
  {
    throw ContentError("found the names of columns " +
      Quote(line.data(), line.data() + line.size() - 1) + ", expected x, y, z and a radius");
  }
  if (!complaint.empty())
  {
    throw ContentError(complaint);
  }
  return columns;
}
}
