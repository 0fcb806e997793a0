// SPDX-License-Identifier: BSD-3-Clause
/// What TraceTile() does, compiled once for each kind of processor.
#ifndef TileTracer_h
#define TileTracer_h

#include "trace/BlockCaster.h"

namespace spherepacking
{
inline namespace SPHEREPACKING_ISA
{
/// Casts the rays of a tile, block by block.
template <typename TraceBlockT>
class TileTracer
{
public:
  TileTracer(const Scene& scene, const CameraRays& rays, const Double3& toEye, int samples,
    const Picture& picture, const TraceBlockT& traceBlock)
    : Colors(scene.Colors)
    , Samples(samples)
    , Output(picture)
    , Block(scene, rays, toEye, traceBlock)
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
    this->Block.Cast(0.5, 0.5);
    this->ForEachPixel([this](int i, std::int64_t pixel) { this->Write(i, pixel); });
    if (this->Samples == 1)
    {
      this->ForEachPixel(
        [this](int i, std::int64_t pixel) { this->Shade(i, this->Output.Color + 4 * pixel); });
      return;
    }
    std::fill_n(&this->Sums[0][0], 4 * RayBlock::Count, 0);
    for (int row = 0; row < this->Samples; ++row)
    {
      for (int column = 0; column < this->Samples; ++column)
      {
        this->Block.Cast((column + 0.5) / this->Samples, (row + 0.5) / this->Samples);
        this->ForEachPixel([this](int i, std::int64_t) { this->AddSample(i); });
      }
    }
    this->ForEachPixel(
      [this](int i, std::int64_t pixel) { this->Average(i, this->Output.Color + 4 * pixel); });
  }

  template <typename Work>
  void ForEachPixel(const Work& work) const
  {
    this->Block.ForEachPixel(
      this->Output.Width, [&](int i, std::int64_t pixel, int, int) { work(i, pixel); });
  }

  void Write(int i, std::int64_t pixel)
  {
    this->Block.Write(i, this->Output.Id[pixel], this->Output.Depth[pixel]);
    const bool hit = this->Output.Id[pixel] >= 0;
    for (int axis = 0; axis < 3; ++axis)
    {
      this->Output.Normal[3 * pixel + axis] =
        hit ? static_cast<float>(this->Block.Surface.Normal[axis][i]) : 0.0f;
    }
  }

  // Lit by a headlight (Lambert).
  void Shade(int i, unsigned char* color) const
  {
    const std::int64_t id = IdOf(this->Block.Rays.Key[i]);
    const double cosine = this->Block.Surface.Cosine[i];
    for (int channel = 0; channel < 3; ++channel)
    {
      color[channel] =
        id < 0 ? 0 : static_cast<unsigned char>(this->Colors[4 * id + channel] * cosine + 0.5);
    }
    color[3] = id < 0 ? 0 : this->Colors[4 * id + 3];
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

  const unsigned char* const Colors;
  const int Samples;
  const Picture& Output;
  BlockCaster<TraceBlockT> Block;
  int Sums[RayBlock::Count][4];
};

inline void TraceTileImpl(const Scene& scene, const CameraRays& rays, const Double3& toEye,
  int samples, const Tile& tile, const Picture& picture)
{
  WithBlockTracer(scene, rays,
    [&](const auto& traceBlock)
    {
      TileTracer<std::decay_t<decltype(traceBlock)>>(
        scene, rays, toEye, samples, picture, traceBlock)
        .Run(tile);
    });
}
}
}

#endif
