// SPDX-License-Identifier: BSD-3-Clause
/// Path tracing of a tile of a camera's picture.
///
/// Spheres are opaque and diffuse (Lambert), on their outside alone: what is seen from inside of a
/// sphere is lit as its other side is. A path starts at the camera, is scattered by each sphere in
/// a direction of the cosine-weighted hemisphere, and ends in the sky. The sun, and the sky if it
/// is an image, are sampled by next-event estimation; the sky's samples and scattered directions
/// are combined by multiple importance sampling with the balance heuristic (Veach and Guibas,
/// "Optimally Combining Sampling Techniques for Monte Carlo Rendering", 1995). From the fourth
/// sphere on paths are subject to Russian roulette (Arvo and Kirk, "Particle Transport and Image
/// Synthesis", 1990).
///
/// Sample i of a pixel depends on i, the seed and the pixel alone, and samples are added up one
/// after the other, so that neither tiles nor threads nor interruptions change the picture. Where
/// in a pixel sample i lies is the same in all pixels, so that neighbouring rays stay a packet.
#ifndef TracePaths_h
#define TracePaths_h

#include "light/Sky.h"
#include "trace/TraceTile.h"

#include <cstdint>

namespace spherepacking
{
/// Lights, material and the sampler's seed.
struct PathLight
{
  spherepacking::Sky Sky;
  spherepacking::Sun Sun;
  float Albedo = 0.8f; ///< of a white sphere
  int MaxBounces = 4;  ///< spheres that a path may visit
  std::uint64_t Seed = 0;
};

/// What has been added up so far; rows from the bottom. Means are over all samples of the pixel,
/// and those that hit nothing have the normal and the albedo 0.
struct PathPicture
{
  int Width;
  int Height;
  float* Radiance; ///< mean, red, green, blue
  float* Albedo;   ///< mean
  float* Normal;   ///< mean
  float* Depth;    ///< through the pixel's middle
  long long* Id;   ///< the same
  float* Variance; ///< of the mean's luminance, as if samples were independent of each other
  float* Coverage; ///< fraction of the samples that hit a sphere
  unsigned* Samples;
};

/// Of linear Rec. 709 primaries, which are those of sRGB.
inline float Luminance(const float* color)
{
  return 0.2126f * color[0] + 0.7152f * color[1] + 0.0722f * color[2];
}

/// The pixels that still get samples: all of them, those of some cells, or one in stride x stride.
struct PathCells
{
  static constexpr int Side = 32;

  const unsigned char* Active = nullptr; ///< row by row; all are if null
  int Columns = 0;
  int Stride = 1; ///< of pixels, along x and y

  bool IsActive(int x, int y) const
  {
    return x % this->Stride == 0 && y % this->Stride == 0 &&
      (!this->Active || this->Active[y / Side * this->Columns + x / Side]);
  }
};

/// Brings the pixels of a tile, in active cells, up to a number of samples.
void TracePaths(const Scene& scene, const CameraRays& rays, const PathLight& light,
  unsigned samples, const PathCells& cells, const Tile& tile, const PathPicture& picture);
}

#endif
