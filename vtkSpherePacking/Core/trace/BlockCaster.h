// SPDX-License-Identifier: BSD-3-Clause
#ifndef BlockCaster_h
#define BlockCaster_h

#include "trace/FirstHit.h"
#include "trace/TraceBvhBlock.h"
#include "trace/TraceTile.h"

namespace spherepacking
{
inline namespace SPHEREPACKING_ISA
{
/// The grid is traversed by one ray at a time.
inline void TraceBlock(const GridTable& table, const SphereArrays& spheres, RayBlock& block)
{
  for (int i = 0; i < RayBlock::Count; ++i)
  {
    const Hit hit = FirstHit(table, spheres, block.RayAt(i), PrimaryRay());
    block.T[i] = hit.T;
    block.Key[i] = MakeKey(hit.Id, 0);
  }
}

/// Normals of a block's hits and their cosine with the headlight; anything where nothing is hit.
struct BlockSurface
{
  alignas(64) double Normal[3][RayBlock::Count];
  alignas(64) double Cosine[RayBlock::Count];

  void Find(const RayBlock& block, const Scene& scene, const Double3& toEye)
  {
    // Those of the leaves have just been seen.
    const bool exact = scene.Hierarchy && scene.Hierarchy->Exact;
    for (const std::int64_t key : block.Key)
    {
      if (key >= 0)
      {
        __builtin_prefetch(scene.Colors + 4 * IdOf(key));
        if (!exact)
        {
          scene.Spheres.Prefetch(IdOf(key));
        }
      }
    }
    for (int first = 0; first < RayBlock::Count; first += RayBlock::Lanes)
    {
      Double4 center[3] = {};
      Double4 radius = {};
      for (int k = 0; k < RayBlock::Lanes; ++k)
      {
        const std::int64_t key = block.Key[first + k];
        const Sphere sphere = key < 0 ? Sphere{ 0.0, 0.0, 0.0, 1.0 }
          : exact                     ? scene.Hierarchy->At(SlotOf(key))
                                      : scene.Spheres[IdOf(key)];
        center[0][k] = sphere.X;
        center[1][k] = sphere.Y;
        center[2][k] = sphere.Z;
        radius[k] = sphere.R;
      }
      const Double4 f[3] = { center[0] - Load<Double4>(block.OX + first),
        center[1] - Load<Double4>(block.OY + first), center[2] - Load<Double4>(block.OZ + first) };
      const Double4 d[3] = { Load<Double4>(block.DX + first), Load<Double4>(block.DY + first),
        Load<Double4>(block.DZ + first) };
      Double4 normal[3];
      NormalAt<Double4>(f, radius, d, Load<Double4>(block.InverseSquare + first),
        Load<Double4>(block.T + first), normal);
      const Double4 cosine = normal[0] * toEye[0] + normal[1] * toEye[1] + normal[2] * toEye[2];
      Store(cosine < 0.0 ? -cosine : cosine, this->Cosine + first);
      for (int axis = 0; axis < 3; ++axis)
      {
        Store(normal[axis], this->Normal[axis] + first);
      }
    }
  }
};

/// Calls `work` with what traces a block through the structure of the scene.
template <typename Work>
inline void WithBlockTracer(const Scene& scene, const CameraRays& rays, const Work& work)
{
  if (scene.Hierarchy)
  {
    const CameraProjection camera(rays);
    work(
      [&](RayBlock& block) { TraceBlock(*scene.Hierarchy, scene.Spheres, rays, camera, block); });
  }
  else if (scene.Table)
  {
    work([&](RayBlock& block) { TraceBlock(*scene.Table, scene.Spheres, block); });
  }
  else
  {
    work([&](RayBlock& block) { TraceBlock(scene.Spheres, block); });
  }
}

/// Calls `work` with each block of a tile; those at the right and at the top may be smaller.
template <typename Work>
inline void ForEachBlock(const Tile& tile, const Work& work)
{
  for (int y = tile.Y; y < tile.Y + tile.Height; y += RayBlock::Side)
  {
    for (int x = tile.X; x < tile.X + tile.Width; x += RayBlock::Side)
    {
      work(Tile{ x, y, std::min(RayBlock::Side, tile.X + tile.Width - x),
        std::min(RayBlock::Side, tile.Y + tile.Height - y) });
    }
  }
}

/// Casts one ray per pixel of a block: what the ray caster and the path tracer have in common.
template <typename TraceBlockT>
class BlockCaster
{
public:
  RayBlock Rays;
  BlockSurface Surface;
  Tile Pixels; ///< of the block

  BlockCaster(const Scene& scene, const CameraRays& camera, const Double3& toEye,
    const TraceBlockT& traceBlock)
    : Input(scene)
    , Camera(camera)
    , ToEye(toEye)
    , TraceBlock(traceBlock)
  {
  }

  /// Casts rays through the same point of each pixel, (0.5, 0.5) for the middle.
  void Cast(double x, double y)
  {
    this->Rays.Start(this->Camera, this->Pixels.X + x, this->Pixels.Y + y);
    this->TraceBlock(this->Rays);
    this->Surface.Find(this->Rays, this->Input, this->ToEye);
  }

  /// Calls `work` with the index of the ray, the index of its pixel in a picture of that width, and
  /// the pixel's column and row.
  template <typename Work>
  void ForEachPixel(int width, const Work& work) const
  {
    for (int row = 0; row < this->Pixels.Height; ++row)
    {
      const int y = this->Pixels.Y + row;
      for (int column = 0; column < this->Pixels.Width; ++column)
      {
        const int x = this->Pixels.X + column;
        work(row * RayBlock::Side + column, static_cast<std::int64_t>(y) * width + x, x, y);
      }
    }
  }

  /// Sphere and depth that ray i hits.
  void Write(int i, long long& id, float& depth) const
  {
    id = IdOf(this->Rays.Key[i]);
    depth = id >= 0 ? static_cast<float>(this->Rays.T[i]) : Miss::Depth;
  }

private:
  const Scene& Input;
  const CameraRays& Camera;
  const Double3& ToEye;
  const TraceBlockT& TraceBlock;
};
}
}

#endif
