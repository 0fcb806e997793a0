// SPDX-License-Identifier: BSD-3-Clause
// What a vtkSpherePackingPathTracer has traced so far. Private to the module.
#ifndef vtkSpherePackingPathState_h
#define vtkSpherePackingPathState_h

#include "kernels/PathTile.h"

#include "vtkABINamespace.h"
#include "vtkSmartPointer.h"

#include <functional>
#include <string>
#include <vector>

VTK_ABI_NAMESPACE_BEGIN
class vtkImageData;

struct vtkSpherePackingPathState
{
  // What the picture depends on, other than the number of samples.
  std::string Key;
  spherepacking::PathPicture Picture{};
  unsigned char* Color = nullptr; // RGBA, made from the others

  // Where it was seen from, and the sky behind the spheres.
  spherepacking::CameraRays Rays{};
  spherepacking::Sky From;

  // The most samples that a pixel has.
  unsigned Most = 0;

  // Starts anew unless the key is the same, no pixel has more samples than are wanted, and the
  // arrays are there and as they were when they were given away.
  void Begin(const std::string& key, const int (&size)[2], unsigned samples);

  // Gives the arrays to an output. They stay the state's as well; whoever still holds them when the
  // next run begins keeps them, and the state goes on with copies.
  void Share(vtkImageData* output);

  // The sky behind the middle of a pixel.
  void SeeSky(std::int64_t pixel, float (&radiance)[3]) const;

  // The pixel whose light a pixel shows: its own, or if it has none that of the lower left one of
  // `stride` x `stride`.
  std::int64_t ShownAt(std::int64_t pixel, int stride) const
  {
    const int width = this->Picture.Width;
    return this->Picture.Samples[pixel] > 0
      ? pixel
      : pixel - pixel % width % stride - pixel / width % stride * width;
  }

  // Samples that all pixels have together.
  double CountSamples() const;

private:
  void Point();
  std::uint64_t Digest() const;

  vtkSmartPointer<vtkImageData> Arrays;
  std::uint64_t Shared = 0; // digest of what was given away
};

// Which cells of a picture need more samples.
class vtkSpherePackingPathCells
{
public:
  explicit vtkSpherePackingPathCells(const spherepacking::PathPicture& picture);

  // Leaves out the cells whose pixels all have this number of samples and whose relative error is
  // no more than `target`.
  void LeaveOut(unsigned samples, double target);

  bool Any() const;
  spherepacking::PathCells Get() const { return { this->Active.data(), this->Columns }; }

private:
  bool IsDone(int column, int row, unsigned samples, double target) const;

  const spherepacking::PathPicture& Picture;
  int Columns;
  int Rows;
  std::vector<unsigned char> Active;
};
VTK_ABI_NAMESPACE_END

#endif
