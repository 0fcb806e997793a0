// SPDX-License-Identifier: BSD-3-Clause
/// The film of the path tracer: the picture as it has been accumulated so far.
#ifndef PathFilm_h
#define PathFilm_h

#include "bridge/PreparedScene.h"
#include "light/TracePaths.h"

#include "vtkSmartPointer.h"

#include <algorithm>

class vtkImageData;

namespace spherepacking
{
/// What a path-traced picture depends on, but for the number of samples.
struct FilmState
{
  SceneState Scene;
  CameraRays Rays{};
  int Width = 0;
  int Height = 0;
  PathLight Light; ///< two states with an image as the sky differ by SkyImage and SkyImageTime
  const vtkImageData* SkyImage = nullptr;
  vtkMTimeType SkyImageTime = 0;

  bool operator==(const FilmState& other) const;
};

class PathFilm
{
public:
  /// Goes on with what has been accumulated if it depends on the same, no pixel has more samples
  /// than are wanted, and the arrays are there and as they were when they were shared; else starts
  /// anew.
  void Start(const FilmState& state, unsigned samples);

  /// Gives the arrays to an output. They stay the film's as well; whoever still holds them when the
  /// next run starts keeps them, and the film goes on with copies.
  void ShareWith(vtkImageData* output);

  /// Where samples are added.
  const PathPicture& Picture() const { return this->Pixels; }
  unsigned char* Color() const { return this->Rgba; }

  /// Says that a pixel may have so many samples now.
  void NoteSamples(unsigned samples) { this->MostSamples = std::max(this->MostSamples, samples); }

  /// Sum over all pixels.
  double CountSamples() const;

  /// The sky behind the middle of a pixel.
  void SkyBehind(std::int64_t pixel, float (&radiance)[3]) const;

  /// The pixel whose light a pixel shows in a preview: its own if it has a sample, else that of the
  /// lower left one of `stride` x `stride`.
  std::int64_t ShownPixel(std::int64_t pixel, int stride) const
  {
    const int width = this->Pixels.Width;
    return this->Pixels.Samples[pixel] > 0
      ? pixel
      : pixel - pixel % width % stride - pixel / width % stride * width;
  }

private:
  bool CanContinue(const FilmState& state, unsigned samples) const;
  void CopySharedArrays();
  void Clear();
  void PointToArrays();
  std::uint64_t ContentHash() const;

  FilmState State;
  PathPicture Pixels{};
  unsigned char* Rgba = nullptr; ///< tone-mapped from the others
  unsigned MostSamples = 0;      ///< of any pixel
  vtkSmartPointer<vtkImageData> Arrays;
  std::uint64_t SharedHash = 0; ///< of the arrays when they were shared
};
}

#endif
