// SPDX-License-Identifier: BSD-3-Clause
/// What TracePaths() does, compiled once for each kind of processor.
#ifndef PathTileTracer_h
#define PathTileTracer_h

#include "light/PathBlock.h"
#include "trace/BlockCaster.h"

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
    unsigned samples, const PathCells& cells, const PathPicture& picture,
    const TraceBlockT& traceBlock)
    : Spheres(scene.Spheres)
    , Light(light)
    , PixelSampler(light.Seed)
    , Samples(samples)
    , Cells(cells)
    , Output(picture)
    , Block(scene, rays, NoLight, traceBlock)
    , Paths(scene, light)
  {
  }

  void Run(const Tile& tile)
  {
    ForEachBlock(tile,
      [this](const Tile& pixels)
      {
        this->Block.Pixels = pixels;
        this->RunBlock();
      });
  }

private:
  void RunBlock()
  {
    unsigned least = this->Samples;
    this->ForEachActive(
      [&](int, std::int64_t pixel) { least = std::min(least, this->Output.Samples[pixel]); });
    if (least == 0 && this->Samples > 0)
    {
      this->Block.Cast(0.5, 0.5);
      this->Block.ForEachPixel(this->Output.Width, [this](int i, std::int64_t pixel, int, int)
        { this->Block.Write(i, this->Output.Id[pixel], this->Output.Depth[pixel]); });
    }
    for (unsigned index = least; index < this->Samples;)
    {
      this->Paths.Count = 0;
      std::fill_n(this->Pending, RayBlock::Count, false);
      const unsigned end = std::min(this->Samples, index + SamplesTogether);
      for (; index < end; ++index)
      {
        this->StartPaths(index);
      }
      this->Paths.Trace();
      for (int k = 0; k < this->Paths.Count; ++k)
      {
        this->FinishPath(this->Paths.Paths[k]);
      }
    }
  }

  // Starts the paths of one sample of each pixel.
  void StartPaths(unsigned index)
  {
    const Point2 point = this->PixelSampler.At(index, 0);
    this->Block.Cast(point.X, point.Y);
    this->ForEachActive(
      [&](int i, std::int64_t pixel)
      {
        if (this->Output.Samples[pixel] <= index)
        {
          this->StartPath(i, pixel, index);
        }
      });
  }

  // Calls `work` with the index of the ray and the index of the pixel.
  template <typename Work>
  void ForEachActive(const Work& work) const
  {
    this->Block.ForEachPixel(this->Output.Width,
      [&](int i, std::int64_t pixel, int x, int y)
      {
        if (this->Cells.IsActive(x, y))
        {
          work(i, pixel);
        }
      });
  }

  // Starts a path where a sphere is hit, else adds the sky behind the pixel.
  void StartPath(int i, std::int64_t pixel, unsigned index)
  {
    const bool hit = this->Block.Rays.Key[i] >= 0;
    if (!hit && !this->Pending[i])
    {
      float radiance[3];
      this->SkyBehind(i, radiance);
      this->Accumulate(pixel, index + 1, radiance, Nothing, Nothing, 0.0f);
      return;
    }
    this->Pending[i] = true;
    Path& path = this->Paths.Paths[this->Paths.Count++];
    path.Index = index;
    path.Ray = i;
    path.Id = IdOf(this->Block.Rays.Key[i]);
    if (!hit)
    {
      this->SkyBehind(i, path.Radiance);
      std::fill_n(path.FirstAlbedo, 3, 0.0f);
      std::fill_n(path.FirstNormal, 3, 0.0f);
      return;
    }
    for (int axis = 0; axis < 3; ++axis)
    {
      path.Normal[axis] = this->Block.Surface.Normal[axis][i];
      path.FirstNormal[axis] = static_cast<float>(path.Normal[axis]);
      path.Radiance[axis] = 0.0f;
    }
    path.PlaceOn(this->Spheres[path.Id], path.Id);
    this->Paths.AlbedoOf(path.Id, path.Throughput);
    this->Paths.AlbedoOf(path.Id, path.FirstAlbedo);
    path.Seed = MixBits(this->Light.Seed ^ MixBits(static_cast<std::uint64_t>(pixel)));
  }

  void SkyBehind(int i, float (&radiance)[3]) const
  {
    const double inverseLength = std::sqrt(this->Block.Rays.InverseSquare[i]);
    const double d[3] = { this->Block.Rays.DX[i] * inverseLength,
      this->Block.Rays.DY[i] * inverseLength, this->Block.Rays.DZ[i] * inverseLength };
    this->Light.Sky.Radiance(d, radiance);
  }

  // Adds what a path has collected to its pixel.
  void FinishPath(const Path& path)
  {
    const int i = path.Ray;
    const std::int64_t pixel =
      static_cast<std::int64_t>(this->Block.Pixels.Y + i / RayBlock::Side) * this->Output.Width +
      this->Block.Pixels.X + i % RayBlock::Side;
    this->Accumulate(pixel, path.Index + 1, path.Radiance, path.FirstAlbedo, path.FirstNormal,
      path.Id < 0 ? 0.0f : 1.0f);
  }

  void Accumulate(std::int64_t pixel, unsigned number, const float (&radiance)[3],
    const float (&albedo)[3], const float (&normal)[3], float coverage)
  {
    const float weight = 1.0f / static_cast<float>(number);
    float* mean = this->Output.Radiance + 3 * pixel;
    const float before = Luminance(radiance) - Luminance(mean);
    MoveMean(mean, radiance, weight);
    const float after = Luminance(radiance) - Luminance(mean);
    MoveMean(this->Output.Albedo + 3 * pixel, albedo, weight);
    MoveMean(this->Output.Normal + 3 * pixel, normal, weight);
    this->Output.Coverage[pixel] += (coverage - this->Output.Coverage[pixel]) * weight;
    this->Output.Samples[pixel] = number;
    if (number > 1)
    {
      // Source: Welford, "Note on a Method for Calculating Corrected Sums of Squares and Products"
      // (1962): the sum of squares, over n (n - 1).
      const auto n = static_cast<float>(number);
      float& variance = this->Output.Variance[pixel];
      variance = (variance * (n - 2.0f) + before * after / (n - 1.0f)) / n;
    }
  }

  static void MoveMean(float* mean, const float (&value)[3], float weight)
  {
    for (int channel = 0; channel < 3; ++channel)
    {
      mean[channel] += (value[channel] - mean[channel]) * weight;
    }
  }

  // Samples whose paths are traced at the same time, so that streams have more rays of a kind.
  static constexpr unsigned SamplesTogether = RayStream::Maximum / RayBlock::Count;
  static constexpr float Nothing[3] = {};
  static constexpr Double3 NoLight = { 0.0, 0.0, 0.0 };

  const SphereArrays& Spheres;
  const PathLight& Light;
  const OwenSobol PixelSampler; // where in a pixel samples lie
  const unsigned Samples;
  const PathCells& Cells;
  const PathPicture& Output;
  BlockCaster<TraceBlockT> Block;
  PathBlock Paths;
  bool Pending[RayBlock::Count]; // pixels whose sums wait for their paths
};

inline void TracePathsImpl(const Scene& scene, const CameraRays& rays, const PathLight& light,
  unsigned samples, const PathCells& cells, const Tile& tile, const PathPicture& picture)
{
  WithBlockTracer(scene, rays,
    [&](const auto& traceBlock)
    {
      // Too large for the stack.
      std::make_unique<PathTileTracer<std::decay_t<decltype(traceBlock)>>>(
        scene, rays, light, samples, cells, picture, traceBlock)
        ->Run(tile);
    });
}
}
}

#endif
