// SPDX-License-Identifier: BSD-3-Clause
// Where a grid has to reach.
#ifndef EncloseSurface_h
#define EncloseSurface_h

#include "metaballs/FieldScene.h"

namespace spherepacking
{
class FieldInput;

// Sets a box on whose sides the field is below `threshold`, as seen at `places` x `places` points
// of each. Of kernels that end, or nearly so, a box outside which nothing reaches the threshold.
// False if there is nothing to enclose.
bool EncloseSurface(
  const FieldInput& input, BlobKind kind, double threshold, int places, double (&box)[6]);

// The origin and the power of two that make a box about 1 long.
void ScaleOf(const double (&box)[6], double (&origin)[3], double& scale);
}

#endif
