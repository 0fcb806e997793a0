// SPDX-License-Identifier: BSD-3-Clause
#ifndef DockCluster_h
#define DockCluster_h

#include "io/LineScanner.h"

#include <optional>

namespace spherepacking
{
/// The line before the spheres of a cluster in a file of DOCK (I. Kuntz et al., "A geometric
/// approach to macromolecule-ligand interactions", 1982).
struct DockCluster
{
  int Number;
  vtkIdType Size;
};

/// The current line, "cluster 1 number of spheres in cluster 23"; nothing if it is another.
std::optional<DockCluster> ParseDockCluster(const LineScanner& scanner);
}

#endif
