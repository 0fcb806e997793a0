// SPDX-License-Identifier: BSD-3-Clause
/// What TracePaths() does, compiled once for each kind of processor.
#ifndef PathTileTracer_h
#define PathTileTracer_h

#include "light/PathBlock.h"
#include "trace/TileTracer.h"

#include <memory>

namespace spherepacking
{
inline namespace SPHEREPACKING_ISA
{
/// Adds samples to the pixels of a tile, block by block.
template <typename TraceBlockT>
class PathTileTracer
{
public:
  PathTileTracer(const Scene& scene, const CameraRays& rays, const PathLight& light,
    unsigned samples, const PathCells& cells, const PathPicture& picture, const TraceBlockT& trace)
    : In(scene)
    , Rays(rays)
    , Light(light)
    , Places(light.Seed)
    , Samples(samples)
    , Cells(cells)
    , Out(picture)
    , Trace(trace)
    , Paths(scene, light)
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
    unsigned least = this->Samples;
    this->ForEachActive(
      [&](int, std::int64_t pixel) { least = std::min(least, this->Out.Samples[pixel]); });
    if (least == 0 && this->Samples > 0)
    {
      this->TraceThrough({ 0.5, 0.5 });
      this->ForEachPixel(
        [this](int i, std::int64_t pixel, int, int) { this->WriteMiddle(i, pixel); });
    }
    for (unsigned index = least; index < this->Samples;)
    {
      this->Paths.Count = 0;
      std::fill_n(this->Pending, RayBlock::Count, false);
      const unsigned end = std::min(this->Samples, index + Together);
      for (; index < end; ++index)
      {
        this->TraceThrough(this->Places.At(index, 0));
        this->ForEachActive(
          [&](int i, std::int64_t pixel)
          {
            if (this->Out.Samples[pixel] <= index)
            {
              this->Begin(i, pixel, index);
            }
          });
      }
      this->Paths.Follow();
      for (int k = 0; k < this->Paths.Count; ++k)
      {
        this->End(this->Paths.Paths[k]);
      }
    }
  }

  void TraceThrough(const Point2& place)
  {
    this->Block.Start(this->Rays, this->Part.X + place.X, this->Part.Y + place.Y);
    this->Trace(this->Block);
    this->Surface.Find(this->Block, this->In, NoLight);
  }

  // Calls `work` with the number of the ray, the pixel, and where that is.
  template <typename Work>
  void ForEachPixel(const Work& work)
  {
    for (int row = 0; row < this->Part.Height; ++row)
    {
      const int y = this->Part.Y + row;
      for (int column = 0; column < this->Part.Width; ++column)
      {
        const int x = this->Part.X + column;
        work(
          row * RayBlock::Side + column, static_cast<std::int64_t>(y) * this->Out.Width + x, x, y);
      }
    }
  }

  template <typename Work>
  void ForEachActive(const Work& work)
  {
    this->ForEachPixel(
      [&](int i, std::int64_t pixel, int x, int y)
      {
        if (this->Cells.IsActive(x, y))
        {
          work(i, pixel);
        }
      });
  }

  void WriteMiddle(int i, std::int64_t pixel)
  {
    const bool hit = this->Block.Key[i] >= 0;
    this->Out.Id[pixel] = IdOf(this->Block.Key[i]);
    this->Out.Depth[pixel] =
      hit ? static_cast<float>(this->Block.T[i]) : std::numeric_limits<float>::infinity();
  }

  // Begins a path where a sphere is hit, else adds what is seen of the sky.
  void Begin(int i, std::int64_t pixel, unsigned index)
  {
    const bool hit = this->Block.Key[i] >= 0;
    if (!hit && !this->Pending[i])
    {
      float radiance[3];
      this->SeeSky(i, radiance);
      this->Accumulate(pixel, index + 1, radiance, Nothing, Nothing, 0.0f);
      return;
    }
    this->Pending[i] = true;
    Path& path = this->Paths.Paths[this->Paths.Count++];
    path.Index = index;
    path.Ray = i;
    path.Id = IdOf(this->Block.Key[i]);
    if (!hit)
    {
      this->SeeSky(i, path.Radiance);
      std::fill_n(path.FirstAlbedo, 3, 0.0f);
      std::fill_n(path.FirstNormal, 3, 0.0f);
      return;
    }
    for (int axis = 0; axis < 3; ++axis)
    {
      path.Normal[axis] = this->Surface.Normal[axis][i];
      path.FirstNormal[axis] = static_cast<float>(path.Normal[axis]);
      path.Radiance[axis] = 0.0f;
    }
    path.Start(this->In.Spheres[path.Id], path.Id);
    this->Paths.AlbedoOf(path.Id, path.Weight);
    this->Paths.AlbedoOf(path.Id, path.FirstAlbedo);
    path.Seed = MixBits(this->Light.Seed ^ MixBits(static_cast<std::uint64_t>(pixel)));
  }

  void SeeSky(int i, float (&radiance)[3]) const
  {
    const double share = std::sqrt(this->Block.InverseSquare[i]);
    const double d[3] = { this->Block.DX[i] * share, this->Block.DY[i] * share,
      this->Block.DZ[i] * share };
    this->Light.Sky.Radiance(d, radiance);
  }

  void End(const Path& path)
  {
    const int i = path.Ray;
    const std::int64_t pixel =
      static_cast<std::int64_t>(this->Part.Y + i / RayBlock::Side) * this->Out.Width +
      this->Part.X + i % RayBlock::Side;
    this->Accumulate(pixel, path.Index + 1, path.Radiance, path.FirstAlbedo, path.FirstNormal,
      path.Id < 0 ? 0.0f : 1.0f);
  }

  void Accumulate(std::int64_t pixel, unsigned number, const float (&radiance)[3],
    const float (&albedo)[3], const float (&normal)[3], float covered)
  {
    const float share = 1.0f / static_cast<float>(number);
    float* mean = this->Out.Radiance + 3 * pixel;
    const float before = Luminance(radiance) - Luminance(mean);
    Approach(mean, radiance, share);
    const float after = Luminance(radiance) - Luminance(mean);
    Approach(this->Out.Albedo + 3 * pixel, albedo, share);
    Approach(this->Out.Normal + 3 * pixel, normal, share);
    this->Out.Coverage[pixel] += (covered - this->Out.Coverage[pixel]) * share;
    this->Out.Samples[pixel] = number;
    if (number > 1)
    {
      // Welford's sum of squares, over n (n - 1).
      const auto n = static_cast<float>(number);
      float& variance = this->Out.Variance[pixel];
      variance = (variance * (n - 2.0f) + before * after / (n - 1.0f)) / n;
    }
  }

  static void Approach(float* mean, const float (&value)[3], float share)
  {
    for (int channel = 0; channel < 3; ++channel)
    {
      mean[channel] += (value[channel] - mean[channel]) * share;
    }
  }

  // Samples whose paths are followed at the same time, so that more rays go the same way.
  static constexpr unsigned Together = RayStream::Maximum / RayBlock::Count;
  static constexpr float Nothing[3] = {};
  static constexpr Vector NoLight = { 0.0, 0.0, 0.0 };

  const Scene& In;
  const CameraRays& Rays;
  const PathLight& Light;
  const OwenSobol Places;
  const unsigned Samples;
  const PathCells& Cells;
  const PathPicture& Out;
  const TraceBlockT& Trace;
  RayBlock Block;
  BlockSurface Surface;
  PathBlock Paths;
  bool Pending[RayBlock::Count];
  Tile Part;
};

inline void TracePathsImpl(const Scene& scene, const CameraRays& rays, const PathLight& light,
  unsigned samples, const PathCells& cells, const Tile& tile, const PathPicture& picture)
{
  WithBlockTracer(scene, rays,
    [&](const auto& trace)
    {
      // Too large for the stack.
      std::make_unique<PathTileTracer<std::decay_t<decltype(trace)>>>(
        scene, rays, light, samples, cells, picture, trace)
        ->Run(tile);
    });
}
}
}

#endif
