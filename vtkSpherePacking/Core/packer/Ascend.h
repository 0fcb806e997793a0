// SPDX-License-Identifier: BSD-3-Clause
#ifndef Ascend_h
#define Ascend_h

#include "packer/ClearanceTree.h"

namespace spherepacking
{
/// A bundle method: climbs from a point to a local maximum of the clearance, until the step is a
/// ten millionth of the clearance, and returns the sphere there.
///
/// The clearance is the minimum of many distances, so it has no gradient at a maximum. The bundle
/// is the gradients of all distances that may become the minimum within a step; the shortest vector
/// in their convex hull is the direction of steepest ascent, and where that vanishes the step is
/// shortened. The gradients of the surface are not known beforehand: the tangent planes at the
/// nearest points of all points tried so far are its cutting planes, so that a point of the surface
/// that made a step fail turns the next one.
///
/// Ends early, with a smaller sphere, once the steps are too short to reach a clearance of
/// `required`.
///
/// Sources: Kiwiel, "Methods of descent for nondifferentiable optimization" (1985), for the bundle;
/// Wolfe, "Finding the nearest point in a polytope" (1976), and Gilbert, "An iterative procedure
/// for computing the minimum of a quadratic form on a convex set" (1966), for the shortest vector.
PackedSphere Ascend(const ClearanceTree& tree, const Vector3& start, double step, double required);
}

#endif
