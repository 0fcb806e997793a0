// SPDX-License-Identifier: BSD-3-Clause
#include "vtkSpherePackingPathTracer.h"

#include "bridge/AdaptiveCells.h"
#include "bridge/CameraView.h"
#include "bridge/FieldData.h"
#include "bridge/Guard.h"
#include "bridge/Limits.h"
#include "bridge/PathFilm.h"
#include "bridge/PictureArrays.h"
#include "bridge/PreparedScene.h"
#include "bridge/SmpParallelFor.h"
#include "bridge/TileLoop.h"
#include "light/ToneMap.h"

#include "vtkDataArray.h"
#include "vtkFloatArray.h"
#include "vtkImageData.h"
#include "vtkMath.h"
#include "vtkObjectFactory.h"
#include "vtkPointData.h"
#include "vtkUnsignedCharArray.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <vector>

vtkStandardNewMacro(vtkSpherePackingPathTracer);

namespace
{
using spherepacking::AddFieldArray;
using spherepacking::PathLight;
using spherepacking::Refuse;

// After how many samples a part of the picture may have enough.
constexpr unsigned SamplesPerCheck = 8;

// To how many samples all pixels are brought next: few at first, so that there is a picture soon,
// of one sample if there is little time.
unsigned NextPass(unsigned samples, bool hurry)
{
  constexpr unsigned half = SamplesPerCheck / 2;
  return hurry && samples == 0 ? 1
    : samples < half           ? half
                               : samples / SamplesPerCheck * SamplesPerCheck + SamplesPerCheck;
}

// Of the pixels that are traced first for a preview, along both sides.
constexpr int PreviewStride = 2;

void CheckRange(const char* name, double value, double low, double high, const char* expected)
{
  if (!(low <= value && value <= high))
  {
    Refuse(name, value, expected);
  }
}

void CheckColor(const char* name, const double (&color)[3])
{
  for (const double channel : color)
  {
    CheckRange(name, channel, 0.0, spherepacking::MaxRadiance, "three numbers from 0 to 1e15");
  }
}

std::vector<float> PixelsOf(vtkImageData* image)
{
  vtkDataArray* scalars = image->GetPointData()->GetScalars();
  if (!scalars || scalars->GetNumberOfComponents() != 3 || image->GetDimensions()[2] != 1)
  {
    throw std::invalid_argument(
      "sky: found an image without scalars of three components, expected red, green and blue");
  }
  const int width = image->GetDimensions()[0];
  const int height = image->GetDimensions()[1];
  std::vector<float> pixels(3 * static_cast<std::size_t>(width) * height);
  float* to = pixels.data();
  for (int row = height - 1; row >= 0; --row)
  {
    for (int column = 0; column < width; ++column)
    {
      for (int channel = 0; channel < 3; ++channel)
      {
        const double value =
          scalars->GetComponent(static_cast<vtkIdType>(row) * width + column, channel);
        CheckRange(
          "sky", value, 0.0, spherepacking::MaxRadiance, "an image of numbers from 0 to 1e15");
        *to++ = static_cast<float>(value);
      }
    }
  }
  return pixels;
}

void PrintVector(std::ostream& os, const double (&vector)[3])
{
  os << vector[0] << " " << vector[1] << " " << vector[2] << "\n";
}
}

//------------------------------------------------------------------------------
vtkSpherePackingPathTracer::vtkSpherePackingPathTracer()
  : Film(new spherepacking::PathFilm)
{
}

//------------------------------------------------------------------------------
vtkSpherePackingPathTracer::~vtkSpherePackingPathTracer() = default;

//------------------------------------------------------------------------------
void vtkSpherePackingPathTracer::SetSkyImage(vtkImageData* image)
{
  if (this->SkyImage != image)
  {
    this->SkyImage = image;
    this->Modified();
  }
}

//------------------------------------------------------------------------------
vtkImageData* vtkSpherePackingPathTracer::GetSkyImage()
{
  return this->SkyImage;
}

//------------------------------------------------------------------------------
vtkMTimeType vtkSpherePackingPathTracer::GetMTime()
{
  const vtkMTimeType time = this->Superclass::GetMTime();
  return this->SkyImage ? std::max(time, this->SkyImage->GetMTime()) : time;
}

//------------------------------------------------------------------------------
void vtkSpherePackingPathTracer::Check() const
{
  this->Superclass::Check();
  if (this->NumberOfSamples < 1)
  {
    Refuse("samples", this->NumberOfSamples, "1 or more");
  }
  if (this->MaximumNumberOfBounces < 0)
  {
    Refuse("max_bounces", this->MaximumNumberOfBounces, "0 or more");
  }
  if (this->MinimumNumberOfSamples < 2)
  {
    Refuse("min_samples", this->MinimumNumberOfSamples, "2 or more");
  }
  CheckRange("albedo", this->Albedo, 0.0, 1.0, "a number from 0 to 1");
  CheckColor("sky", this->SkyTop);
  CheckColor("sky", this->SkyBottom);
  CheckColor("sun", this->SunRadiance);
  CheckRange("sun", this->SunDiameter, 0.0, 180.0, "a diameter from 0 to 180 degrees");
  const double length = vtkMath::Norm(this->SunDirection);
  if (!(length > 0.0 && std::isfinite(length)))
  {
    Refuse("sun", length, "a direction of finite length above 0");
  }
  CheckRange("time_budget", this->TimeBudget, 0.0, VTK_DOUBLE_MAX, "0 or more seconds");
  CheckRange("noise_target", this->NoiseTarget, 0.0, VTK_DOUBLE_MAX, "0 or more");
  CheckRange("exposure", this->Exposure, -spherepacking::MaxExposure, spherepacking::MaxExposure,
    "a number from -100 to 100");
}

//------------------------------------------------------------------------------
void vtkSpherePackingPathTracer::SetLight(PathLight& light) const
{
  light.Albedo = static_cast<float>(this->Albedo);
  light.MaxBounces = this->MaximumNumberOfBounces;
  light.Seed = this->Seed;
  const double length = vtkMath::Norm(this->SunDirection);
  for (int i = 0; i < 3; ++i)
  {
    light.Sky.Top[i] = static_cast<float>(this->SkyTop[i]);
    light.Sky.Bottom[i] = static_cast<float>(this->SkyBottom[i]);
    light.Sun.Direction[i] = this->SunDirection[i] / length;
  }
  // 1 - cos(a) = 2 sin(a / 2)^2, and a is half of the diameter.
  const double sine = std::sin(0.25 * vtkMath::RadiansFromDegrees(this->SunDiameter));
  light.Sun.OneMinusCosine = 2.0 * sine * sine;
  for (int i = 0; i < 3; ++i)
  {
    // The parts of the sun do not all stand above a surface that faces its middle: over the mean
    // of the cosine.
    light.Sun.Radiance[i] =
      static_cast<float>(this->SunRadiance[i] / (1.0 - 0.5 * light.Sun.OneMinusCosine));
  }
  if (this->SkyImage)
  {
    const int* size = this->SkyImage->GetDimensions();
    light.Sky.SetImage(PixelsOf(this->SkyImage), size[0], size[1]);
  }
}

// What the passes of a run share.
struct vtkSpherePackingPathTracer::Passes
{
  spherepacking::Scene Scene;
  spherepacking::CameraView View;
  PathLight Light;
  spherepacking::AdaptiveCells Cells;
  spherepacking::TileLoop Tiles;
  std::vector<double> TileSeconds;
  spherepacking::Stopwatch Watch;
  bool Stop = false;
  bool MayBeLate = false; // there is a picture to show
};

//------------------------------------------------------------------------------
bool vtkSpherePackingPathTracer::IsLate(const Passes& run) const
{
  return run.MayBeLate && this->TimeBudget > 0.0 && run.Watch.Seconds() > this->TimeBudget;
}

//------------------------------------------------------------------------------
void vtkSpherePackingPathTracer::RunPass(Passes& run, unsigned before, unsigned samples, int stride)
{
  const auto wanted = static_cast<double>(this->NumberOfSamples);
  spherepacking::PathCells cells = run.Cells.Get();
  cells.Stride = stride;
  run.Tiles.Run(
    [&](const spherepacking::Tile& tile)
    {
      spherepacking::TracePaths(
        run.Scene, run.View.Rays, run.Light, samples, cells, tile, this->Film->Picture());
    },
    [&](double fraction)
    {
      this->UpdateProgress((before + fraction * (samples - before)) / wanted);
      run.Stop = run.Stop || this->CheckAbort() || this->IsLate(run);
      return run.Stop;
    });
  for (std::size_t i = 0; i < run.TileSeconds.size(); ++i)
  {
    run.TileSeconds[i] += run.Tiles.ComputeSeconds[i];
  }
  this->Film->NoteSamples(samples);
}

//------------------------------------------------------------------------------
void vtkSpherePackingPathTracer::RunPasses(Passes& run)
{
  const auto wanted = static_cast<unsigned>(this->NumberOfSamples);
  const bool hurry = this->TimeBudget > 0.0;
  if (hurry && this->Preview)
  {
    this->RunPass(run, 0, 1, PreviewStride);
    run.MayBeLate = true;
  }
  for (unsigned samples = 0; samples < wanted && !run.Stop && run.Cells.Any();)
  {
    if (this->IsLate(run))
    {
      break;
    }
    const unsigned next = std::min(wanted, NextPass(samples, hurry));
    this->RunPass(run, samples, next, 1);
    run.MayBeLate = true;
    samples = next;
    if (this->NoiseTarget > 0.0 && samples % SamplesPerCheck == 0 &&
      samples >= static_cast<unsigned>(this->MinimumNumberOfSamples))
    {
      run.Cells.DropConverged(samples, this->NoiseTarget);
    }
  }
}

//------------------------------------------------------------------------------
void vtkSpherePackingPathTracer::Trace(vtkImageData* output)
{
  const spherepacking::CameraView view = this->FindView();
  const int size[2] = { this->GetWindowSize()[0], this->GetWindowSize()[1] };
  const int tile[2] = { this->GetTileSize()[0], this->GetTileSize()[1] };
  spherepacking::PathFilm& film = *this->Film;
  spherepacking::FilmState state{ this->Prepared->State(), view.Rays, size[0], size[1], {},
    this->SkyImage, this->SkyImage ? this->SkyImage->GetMTime() : 0 };
  this->SetLight(state.Light);
  film.Start(state, static_cast<unsigned>(this->NumberOfSamples));
  const double before = film.CountSamples();
  Passes run{ this->Prepared->Get(), view, state.Light,
    spherepacking::AdaptiveCells(film.Picture()), spherepacking::TileLoop(size, tile), {}, {} };
  run.TileSeconds.assign(run.Tiles.Tiles.size(), 0.0);
  this->RunPasses(run);
  // The executive would throw away what is done.
  this->SetAbortOutput(false);
  this->ToneMap(film.Picture().Radiance, film.Color());
  film.ShareWith(output);
  spherepacking::AddTileExtents(output, run.Tiles.Tiles);
  AddFieldArray(output, "compute_seconds", run.TileSeconds);
  AddFieldArray(output, "complete_seconds", { run.Watch.Seconds() });
  AddFieldArray(output, "build_seconds", { this->Prepared->BuildSeconds() });
  AddFieldArray(output, "memory_bytes", { this->Prepared->StructureBytes() });
  AddFieldArray(output, "traced_samples", { film.CountSamples() - before });
}

//------------------------------------------------------------------------------
bool vtkSpherePackingPathTracer::Develop(vtkFloatArray* radiance, vtkUnsignedCharArray* color)
{
  const spherepacking::PathPicture& picture = this->Film->Picture();
  const vtkIdType pixels = static_cast<vtkIdType>(picture.Width) * picture.Height;
  if (pixels == 0 || !radiance || !color || radiance->GetNumberOfComponents() != 3 ||
    radiance->GetNumberOfTuples() != pixels)
  {
    return false;
  }
  const auto work = [&]
  {
    color->SetNumberOfComponents(4);
    color->SetNumberOfTuples(pixels);
    this->ToneMap(radiance->GetPointer(0), color->GetPointer(0));
    color->Modified();
  };
  return this->RunWith(work);
}

//------------------------------------------------------------------------------
void vtkSpherePackingPathTracer::ToneMap(const float* radiance, unsigned char* color) const
{
  const spherepacking::PathFilm& film = *this->Film;
  const spherepacking::PathPicture& picture = film.Picture();
  const spherepacking::ToneMapper mapper(this->Exposure, this->Filmic);
  spherepacking::SmpFor(0, picture.Height, 0,
    [&](vtkIdType begin, vtkIdType end)
    {
      for (vtkIdType i = begin * picture.Width; i < end * picture.Width; ++i)
      {
        const vtkIdType from = film.ShownPixel(i, PreviewStride);
        const double coverage = this->SkyVisible ? 1.0 : picture.Coverage[from];
        float sky[3] = { 0.0f, 0.0f, 0.0f };
        if (coverage < 1.0)
        {
          film.SkyBehind(from, sky);
        }
        const bool shown = picture.Samples[from] > 0 && coverage > 0.0;
        for (int channel = 0; channel < 3; ++channel)
        {
          // Without the sky, that of the samples that hit a sphere.
          const double own = (radiance[3 * from + channel] - (1.0 - coverage) * sky[channel]) /
            (shown ? coverage : 1.0);
          color[4 * i + channel] = shown ? mapper.Byte(own) : 0;
        }
        color[4 * i + 3] = shown ? static_cast<unsigned char>(255.0 * coverage + 0.5) : 0;
      }
    });
}

//------------------------------------------------------------------------------
void vtkSpherePackingPathTracer::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "NumberOfSamples: " << this->NumberOfSamples << "\n";
  os << indent << "MinimumNumberOfSamples: " << this->MinimumNumberOfSamples << "\n";
  os << indent << "MaximumNumberOfBounces: " << this->MaximumNumberOfBounces << "\n";
  os << indent << "Albedo: " << this->Albedo << "\n";
  os << indent << "Seed: " << this->Seed << "\n";
  PrintVector(os << indent << "SkyTop: ", this->SkyTop);
  PrintVector(os << indent << "SkyBottom: ", this->SkyBottom);
  os << indent << "SkyImage: " << this->SkyImage.Get() << "\n";
  PrintVector(os << indent << "SunDirection: ", this->SunDirection);
  PrintVector(os << indent << "SunRadiance: ", this->SunRadiance);
  os << indent << "SunDiameter: " << this->SunDiameter << "\n";
  os << indent << "TimeBudget: " << this->TimeBudget << "\n";
  os << indent << "Preview: " << (this->Preview ? "On" : "Off") << "\n";
  os << indent << "NoiseTarget: " << this->NoiseTarget << "\n";
  os << indent << "Exposure: " << this->Exposure << "\n";
  os << indent << "Filmic: " << (this->Filmic ? "On" : "Off") << "\n";
  os << indent << "SkyVisible: " << (this->SkyVisible ? "On" : "Off") << "\n";
}
