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
 * and of children a node, then x y z radius and, but for some versions, occupancy of every node,
 * level by level and child by child. A negative radius stands for a node that is not there. Some
 * nodes have an auxiliary sphere in 5 more numbers, which is left out, as are the options and the
 * evaluation that the toolkit's commands append.
 */
PackingArrays ParseToolkitTree(const TextRange& text, bool single, Progress& progress);
}

#endif
