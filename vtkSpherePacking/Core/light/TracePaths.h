// SPDX-License-Identifier: BSD-3-Clause
/// Traces paths of light for a tile of a camera's picture.
///
/// Spheres are opaque and reflect light alike in all directions (Lambert), on their outside alone:
/// what is seen from inside of a sphere is lit as its other side is. A path starts at the camera,
/// goes on from each sphere in a direction drawn in proportion to the cosine, and ends in the sky.
/// On its way it meets the sun, and the sky if that is an image, by rays sent there on purpose,
/// which are weighed against those that come there by chance (Veach and Guibas, "Optimally
/// Combining Sampling Techniques for Monte Carlo Rendering", 1995). From the fourth sphere on it
/// may be ended by chance, and counts the more if it is not (Arvo and Kirk, "Particle Transport and
/// Image Synthesis", 1990).
///
/// Sample i of a pixel depends on i, the seed and the pixel alone, and samples are added up one
/// after the other, so that neither tiles nor threads nor interruptions change the picture. Where
/// in a pixel sample i lies is the same in all pixels, so that neighbouring rays stay a block.
#ifndef TracePaths_h
#define TracePaths_h

#include "light/Sky.h"
#include "trace/TraceTile.h"

#include <cstdint>

namespace spherepacking
{
/// What decides about the light.
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
  float* Depth;    ///< through the pixel's middle, infinite where nothing is hit
  long long* Id;   ///< the same; -1
  float* Variance; ///< of the mean's luminance, as if samples were independent of each other
  float* Coverage; ///< share of the samples that hit a sphere
  unsigned* Samples;
};

/// Of linear Rec. 709 primaries, those of sRGB.
inline float Luminance(const float* color)
{
  return 0.2126f * color[0] + 0.7152f * color[1] + 0.0722f * color[2];
}

/// Cells of the picture in which paths are still traced.
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
