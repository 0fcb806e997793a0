// SPDX-License-Identifier: BSD-3-Clause
#include "io/DockCluster.h"

#include <iterator>

namespace spherepacking
{
//------------------------------------------------------------------------------
std::optional<DockCluster> ParseDockCluster(const LineScanner& scanner)
{
  constexpr std::string_view words[] = { "cluster", {}, "number", "of", "spheres", "in", "cluster",
    {} };
  if (scanner.Line().substr(0, words[0].size()) != words[0])
  {
    return std::nullopt;
  }
  const auto fields = scanner.Fields();
  DockCluster cluster;
  if (fields.size() != std::size(words) || !ParseInteger(fields[1], cluster.Number) ||
    !ParseInteger(fields[7], cluster.Size))
  {
    return std::nullopt;
  }
  for (std::size_t i = 0; i < std::size(words); ++i)
  {
    if (!words[i].empty() && fields[i] != words[i])
    {
      return std::nullopt;
    }
  }
  return cluster;
}
}
