// SPDX-License-Identifier: BSD-3-Clause
/// A packet of 16 x 16 neighbouring camera rays and the closest hit of each so far.
#ifndef RayBlock_h
#define RayBlock_h

#include "trace/CameraRays.h"

#include <cmath>

namespace spherepacking
{
inline namespace SPHEREPACKING_ISA
{
/// A rectangle of rays of a block: columns and rows, first to last.
struct RayRectangle
{
  int X0 = 0;
  int X1 = 15;
  int Y0 = 0;
  int Y1 = 15;

  /// Which cells of 4 x 4 rays it lies in, a bit each, row by row.
  unsigned Cells() const
  {
    const unsigned columns = (2u << this->X1 / 4) - (1u << this->X0 / 4);
    const unsigned rows = ((16u << (this->Y1 & ~3)) - (1u << (this->Y0 & ~3))) & 0x1111u;
    return columns * rows;
  }
};

struct RayBlock
{
  static constexpr int Side = 16;
  static constexpr int CellsSide = Side / 4;
  static constexpr int Lanes = 4; ///< rays that are tested at once
  static constexpr int Count = Side * Side;

  // One array per coordinate, row by row from the bottom.
  alignas(64) double OX[Count];
  alignas(64) double OY[Count];
  alignas(64) double OZ[Count];
  alignas(64) double DX[Count];
  alignas(64) double DY[Count];
  alignas(64) double DZ[Count];
  alignas(64) double InverseSquare[Count];
  alignas(64) double T[Count];
  alignas(64) std::int64_t Key[Count]; ///< MakeKey() of the sphere, negative for none
  double X0;                           ///< of the first ray in the picture
  double Y0;

  /// Rays through (x0 + i, y0 + j), i and j from 0 to 15.
  void Start(const CameraRays& rays, double x0, double y0)
  {
    this->X0 = x0;
    this->Y0 = y0;
    const Hit miss;
    for (int i = 0; i < Count; ++i)
    {
      const Ray ray = rays.At(x0 + i % Side, y0 + i / Side);
      this->OX[i] = ray.O[0];
      this->OY[i] = ray.O[1];
      this->OZ[i] = ray.O[2];
      this->DX[i] = ray.D[0];
      this->DY[i] = ray.D[1];
      this->DZ[i] = ray.D[2];
      this->InverseSquare[i] = spherepacking::InverseSquare(ray);
      this->T[i] = miss.T;
      this->Key[i] = miss.Id;
    }
  }

  Ray RayAt(int i) const
  {
    return { { this->OX[i], this->OY[i], this->OZ[i] }, { this->DX[i], this->DY[i], this->DZ[i] } };
  }

  /// Tests a sphere, which has no hit before `nearest`, against the rays of a rectangle, and some
  /// beside it. Returns whether it is now the closest hit of any.
  bool Offer(const Sphere& sphere, std::int64_t key, const RayRectangle& rays, double nearest)
  {
    bool closer = false;
    // Along the direction of view, no surface that holds an origin begins in front of it.
    const bool mayStartThere = nearest <= 0.0;
    for (int row = rays.Y0; row <= rays.Y1; ++row)
    {
      for (int quad = rays.X0 / Lanes; quad <= rays.X1 / Lanes; ++quad)
      {
        const int first = row * Side + quad * Lanes;
        if (Any(nearest <= Load<Double4>(this->T + first)))
        {
          closer |= this->OfferLanes(sphere, key, first, mayStartThere);
        }
      }
    }
    return closer;
  }

  /// The farthest of the closest hits in a cell of 4 x 4 rays.
  double MaxDepth(int cell) const
  {
    static_assert(Side == CellsSide * Lanes);
    const double* first = this->T + cell / CellsSide * Lanes * Side + cell % CellsSide * Lanes;
    Double4 farthest = Load<Double4>(first);
    for (int row = 1; row < Lanes; ++row)
    {
      const Double4 next = Load<Double4>(first + row * Side);
      farthest = farthest > next ? farthest : next;
    }
    return std::max(std::max(farthest[0], farthest[1]), std::max(farthest[2], farthest[3]));
  }

private:
  bool OfferLanes(const Sphere& sphere, std::int64_t key, int first, bool mayStartThere)
  {
    const auto load = [first](const double* values) { return Load<Double4>(values + first); };
    const Double4 f[3] = { sphere.X - load(this->OX), sphere.Y - load(this->OY),
      sphere.Z - load(this->OZ) };
    const Double4 d[3] = { load(this->DX), load(this->DY), load(this->DZ) };
    const Double4 t = HitSphere<Double4>(f, sphere, d, load(this->InverseSquare), mayStartThere);
    const Double4 best = load(this->T);
    const Long4 bestKey = Load<Long4>(this->Key + first);
    const Long4 closer = (t < best) | ((t == best) & (key < bestKey));
    Store(closer ? t : best, this->T + first);
    Store(closer ? Long4{} + key : bestKey, this->Key + first);
    return Any(closer);
  }
};
}
}

#endif
