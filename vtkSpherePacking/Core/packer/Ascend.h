// SPDX-License-Identifier: BSD-3-Clause
#ifndef Ascend_h
#define Ascend_h

#include "packer/ClearanceTree.h"

namespace spherepacking
{
/// The sphere that is found from a place by going where the clearance grows, until steps as small
/// as a ten millionth of it do not help.
///
/// The clearance is the least of many distances. Those within a step of the least have gradients,
/// of which the shortest vector in their convex hull is the way of steepest ascent; where it
/// vanishes the steps become shorter. Of the surface, the nearest points of all places so far are
/// kept, as planes: a nearest point that stops a step turns the next.
///
/// It ends early, with a smaller sphere, where steps have become so short that `enough` is out of
/// reach.
///
/// Sources: Wolfe, "Finding the nearest point in a polytope" (1976), for the shortest vector;
/// Kiwiel, "Methods of descent for nondifferentiable optimization" (1985), for the planes.
PackedSphere Ascend(const ClearanceTree& tree, const Vector3& start, double step, double enough);
}

#endif
