// SPDX-License-Identifier: BSD-3-Clause
#ifndef EncloseSurface_h
#define EncloseSurface_h

#include "metaballs/FieldScene.h"

namespace spherepacking
{
class PackingCharges;

/// Finds a box around the isosurface at `threshold`, so that the surface is closed inside.
///
/// For the inverse kernels the field is below the threshold on the box's faces, as sampled at
/// `samples` x `samples` points of each. For the others, which vanish or nearly so at a distance,
/// the box is such that outside of it no sphere adds more than the threshold over their number.
/// False if there is nothing to enclose.
bool EncloseSurface(
  const PackingCharges& charges, BlobKind kind, double threshold, int samples, double (&box)[6]);

/// The middle of a box and the power of two by which it becomes about 1 long.
void FindUnitScale(const double (&box)[6], double (&origin)[3], double& scale);
}

#endif
