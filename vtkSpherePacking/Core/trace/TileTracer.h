// SPDX-License-Identifier: BSD-3-Clause
/// What TraceTile() does, compiled once for each kind of processor.
#ifndef TileTracer_h
#define TileTracer_h

#include "trace/FirstHit.h"
#include "trace/TraceTile.h"

namespace spherepacking
{
inline namespace SPHEREPACKING_ISA
{
/// The grid has no way to follow several rays at once.
inline void TraceBlock(const GridTable& table, const SphereArrays& spheres, RayBlock& block)
{
  for (int i = 0; i < RayBlock::Count; ++i)
  {
    const Hit hit = FirstHit(table, spheres, block.RayAt(i), EverySurface());
    block.T[i] = hit.T;
    block.Key[i] = MakeKey(hit.Id, 0);
  }
}

/// Normals of a block's hits and how bright they are; anything where nothing is hit.
struct BlockSurface
{
  alignas(64) double Normal[3][RayBlock::Count];
  alignas(64) double Brightness[RayBlock::Count];

  void Find(const RayBlock& block, const Scene& scene, const Vector& toEye)
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
          : exact                     ? scene.Hierarchy->At(PlaceOf(key))
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
      NormalAt<Double4>(f, radius, d, Load<Double4>(block.InverseSquare + first), normal);
      const Double4 cosine = normal[0] * toEye[0] + normal[1] * toEye[1] + normal[2] * toEye[2];
      Store(cosine < 0.0 ? -cosine : cosine, this->Brightness + first);
      for (int axis = 0; axis < 3; ++axis)
      {
        Store(normal[axis], this->Normal[axis] + first);
      }
    }
  }
};

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

/// Traces the blocks of a tile.
template <typename TraceBlockT>
class TileTracer
{
public:
  TileTracer(const Scene& scene, const CameraRays& rays, const Vector& toEye, int samples,
    const Picture& picture, const TraceBlockT& trace)
    : In(scene)
    , Rays(rays)
    , ToEye(toEye)
    , Samples(samples)
    , Out(picture)
    , Trace(trace)
  {
  }

  void Run(const Tile& tile)
  {
    ForEachBlock(tile,
      [this](const Tile& block)
      {
        this->Part = block;
        this->RunBlock();
      });
  }

private:
  void RunBlock()
  {
    this->TraceThrough(0.5, 0.5);
    this->ForEachPixel([this](int i, std::int64_t pixel) { this->Write(i, pixel); });
    if (this->Samples == 1)
    {
      this->ForEachPixel(
        [this](int i, std::int64_t pixel) { this->Shade(i, this->Out.Color + 4 * pixel); });
      return;
    }
    std::fill_n(&this->Sums[0][0], 4 * RayBlock::Count, 0);
    for (int row = 0; row < this->Samples; ++row)
    {
      for (int column = 0; column < this->Samples; ++column)
      {
        this->TraceThrough((column + 0.5) / this->Samples, (row + 0.5) / this->Samples);
        this->ForEachPixel([this](int i, std::int64_t) { this->AddSample(i); });
      }
    }
    this->ForEachPixel(
      [this](int i, std::int64_t pixel) { this->Average(i, this->Out.Color + 4 * pixel); });
  }

  // One ray a pixel, at the same place in each.
  void TraceThrough(double x, double y)
  {
    this->Block.Start(this->Rays, this->Part.X + x, this->Part.Y + y);
    this->Trace(this->Block);
    this->Surface.Find(this->Block, this->In, this->ToEye);
  }

  template <typename Work>
  void ForEachPixel(const Work& work)
  {
    for (int row = 0; row < this->Part.Height; ++row)
    {
      const std::int64_t first =
        static_cast<std::int64_t>(this->Part.Y + row) * this->Out.Width + this->Part.X;
      for (int column = 0; column < this->Part.Width; ++column)
      {
        work(row * RayBlock::Side + column, first + column);
      }
    }
  }

  void Write(int i, std::int64_t pixel)
  {
    const bool hit = this->Block.Key[i] >= 0;
    this->Out.Id[pixel] = IdOf(this->Block.Key[i]);
    this->Out.Depth[pixel] =
      hit ? static_cast<float>(this->Block.T[i]) : std::numeric_limits<float>::infinity();
    for (int axis = 0; axis < 3; ++axis)
    {
      this->Out.Normal[3 * pixel + axis] =
        hit ? static_cast<float>(this->Surface.Normal[axis][i]) : 0.0f;
    }
  }

  void Shade(int i, unsigned char* color) const
  {
    const std::int64_t id = IdOf(this->Block.Key[i]);
    const double light = this->Surface.Brightness[i];
    for (int channel = 0; channel < 3; ++channel)
    {
      color[channel] =
        id < 0 ? 0 : static_cast<unsigned char>(this->In.Colors[4 * id + channel] * light + 0.5);
    }
    color[3] = id < 0 ? 0 : this->In.Colors[4 * id + 3];
  }

  void AddSample(int i)
  {
    unsigned char color[4];
    this->Shade(i, color);
    for (int channel = 0; channel < 3; ++channel)
    {
      this->Sums[i][channel] += color[channel] * color[3];
    }
    this->Sums[i][3] += color[3];
  }

  // Straight alpha: the colour is that of the samples that hit something.
  void Average(int i, unsigned char* color) const
  {
    const int alpha = this->Sums[i][3];
    const int number = this->Samples * this->Samples;
    for (int channel = 0; channel < 3; ++channel)
    {
      color[channel] =
        static_cast<unsigned char>(alpha == 0 ? 0 : (this->Sums[i][channel] + alpha / 2) / alpha);
    }
    color[3] = static_cast<unsigned char>((alpha + number / 2) / number);
  }

  const Scene& In;
  const CameraRays& Rays;
  const Vector& ToEye;
  const int Samples;
  const Picture& Out;
  const TraceBlockT& Trace;
  RayBlock Block;
  BlockSurface Surface;
  int Sums[RayBlock::Count][4];
  Tile Part;
};

/// Calls `work` with what traces a block through the structure of the scene.
template <typename Work>
inline void WithBlockTracer(const Scene& scene, const CameraRays& rays, const Work& work)
{
  if (scene.Hierarchy)
  {
    const Screen screen(rays);
    work(
      [&](RayBlock& block) { TraceBlock(*scene.Hierarchy, scene.Spheres, rays, screen, block); });
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

inline void TraceTileImpl(const Scene& scene, const CameraRays& rays, const Vector& toEye,
  int samples, const Tile& tile, const Picture& picture)
{
  WithBlockTracer(scene, rays,
    [&](const auto& trace)
    {
      TileTracer<std::decay_t<decltype(trace)>>(scene, rays, toEye, samples, picture, trace)
        .Run(tile);
    });
}
}
}

#endif
