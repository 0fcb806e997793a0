// SPDX-License-Identifier: BSD-3-Clause
#ifndef BlockAxis_h
#define BlockAxis_h

#include "accel/Bvh.h"
#include "trace/CameraRays.h"
#include "base/Simd.h"

namespace spherepacking
{
inline namespace SPHEREPACKING_ISA
{
/// A coordinate of the picture, or the depth, as a linear function N.c + D of a point c in the
/// hierarchy's coordinates, single precision. Off by `Error` at most: 10^-6 of what was added up,
/// some ten roundings.
struct BlockAxis
{
  float N[3];
  float D; ///< of the middle of the hierarchy as seen from the eye
  float Error;
  // Dot products N.N, 2 N.Z and Z.Z with the Z of the depth; the last two are 0 in parallel views.
  float NN = 0.0f;
  float TwiceNZ = 0.0f;
  float ZZ = 0.0f;

  void Set(const Double3& n, double scale, double offset, const Double3& eye, const Bvh& bvh)
  {
    double d = 0.0;
    double length = 0.0;
    for (int axis = 0; axis < 3; ++axis)
    {
      const double scaled = n[axis] * scale;
      this->N[axis] = static_cast<float>(scaled);
      d += scaled * (bvh.Center[axis] - eye[axis]) * bvh.Scale;
      length += std::abs(scaled);
    }
    this->D = static_cast<float>(d + offset);
    this->Error = static_cast<float>(1e-6 * (length + std::abs(d + offset)));
  }

  /// N.c + D of eight points.
  Float8 At(const Float8 (&point)[3]) const
  {
    return this->N[0] * point[0] + this->N[1] * point[1] + this->N[2] * point[2] + this->D;
  }

  /// Bounds over each of eight boxes, error included.
  Float8 Least(const BvhNode& node) const { return this->Corners(node, false) - this->Error; }
  Float8 Greatest(const BvhNode& node) const { return this->Corners(node, true) + this->Error; }

private:
  Float8 Corners(const BvhNode& node, bool greatest) const
  {
    Float8 sum = Float8{} + this->D;
    for (int axis = 0; axis < 3; ++axis)
    {
      const float n = this->N[axis];
      sum += n * Load<Float8>((n > 0.0f) == greatest ? node.High[axis] : node.Low[axis]);
    }
    return sum;
  }
};
}
}

#endif
