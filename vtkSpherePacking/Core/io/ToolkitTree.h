// SPDX-License-Identifier: BSD-3-Clause
#ifndef ToolkitTree_h
#define ToolkitTree_h

#include "bridge/PackingArrays.h"
#include "io/Progress.h"
#include "io/TextLines.h"

namespace spherepacking
{
/**
 * Reads a sphere tree of the Sphere-Tree Construction Toolkit (G. Bradshaw and C. O'Sullivan,
 * "Adaptive medial-axis approximation for sphere-tree construction", 2004): the number of levels
 * and of children a node, then x y z radius occupancy of every node, level by level and child by
 * child. A negative radius stands for a node that is not there.
 */
PackingArrays ParseToolkitTree(const TextRange& text, bool single, Progress& progress);
}

#endif
