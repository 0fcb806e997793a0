// SPDX-License-Identifier: BSD-3-Clause
#include "bridge/PathFilm.h"

#include "base/MixBits.h"
#include "bridge/PictureArrays.h"
#include "bridge/SmpParallelFor.h"

#include "vtkFloatArray.h"
#include "vtkImageData.h"
#include "vtkMath.h"
#include "vtkPointData.h"
#include "vtkTypeInt64Array.h"
#include "vtkUnsignedCharArray.h"
#include "vtkUnsignedIntArray.h"

#include <algorithm>
#include <atomic>
#include <cstring>
#include <string>

namespace spherepacking
{
namespace
{
template <typename ArrayT>
auto* ValuesOf(vtkImageData* image, const char* name)
{
  return ArrayT::SafeDownCast(image->GetPointData()->GetArray(name))->GetPointer(0);
}

template <typename Value>
bool Same(const Value (&a)[3], const Value (&b)[3])
{
  return std::equal(a, a + 3, b);
}

bool Same(const CameraRays& a, const CameraRays& b)
{
  return a.Parallel == b.Parallel && Same(a.O0, b.O0) && Same(a.OX, b.OX) && Same(a.OY, b.OY) &&
    Same(a.D0, b.D0) && Same(a.DX, b.DX) && Same(a.DY, b.DY);
}

// But for the image of the sky.
bool Same(const PathLight& a, const PathLight& b)
{
  return Same(a.Sky.Bottom, b.Sky.Bottom) && Same(a.Sky.Top, b.Sky.Top) &&
    Same(a.Sun.Direction, b.Sun.Direction) && Same(a.Sun.Radiance, b.Sun.Radiance) &&
    a.Sun.OneMinusCosine == b.Sun.OneMinusCosine && a.Albedo == b.Albedo &&
    a.MaxBounces == b.MaxBounces && a.Seed == b.Seed;
}

// Of bytes; changes when any of them does, but for a chance of 2^-64.
std::uint64_t HashOf(const char* bytes, std::size_t length)
{
  constexpr std::size_t part = 1 << 16;
  std::atomic<std::uint64_t> sum{ 0 };
  SmpFor(0, static_cast<vtkIdType>((length + part - 1) / part), 16,
    [&](vtkIdType first, vtkIdType last)
    {
      for (vtkIdType i = first; i < last; ++i)
      {
        const std::size_t begin = static_cast<std::size_t>(i) * part;
        const std::size_t end = std::min(begin + part, length);
        std::uint64_t lanes[4] = { 1, 2, 3, static_cast<std::uint64_t>(i) };
        for (std::size_t at = begin; at < end; at += sizeof(lanes))
        {
          std::uint64_t chunk[4] = {};
          std::memcpy(chunk, bytes + at, std::min(sizeof(chunk), end - at));
          for (int lane = 0; lane < 4; ++lane)
          {
            lanes[lane] = (lanes[lane] ^ chunk[lane]) * 0x9e3779b97f4a7c15u;
            lanes[lane] ^= lanes[lane] >> 29;
          }
        }
        std::uint64_t all = 0;
        for (const std::uint64_t lane : lanes)
        {
          all = MixBits(all ^ lane);
        }
        sum += all;
      }
    });
  return sum;
}
}

//------------------------------------------------------------------------------
bool FilmState::operator==(const FilmState& other) const
{
  return this->Scene == other.Scene && Same(this->Rays, other.Rays) && this->Width == other.Width &&
    this->Height == other.Height && Same(this->Light, other.Light) &&
    this->SkyImage == other.SkyImage && this->SkyImageTime == other.SkyImageTime;
}

//------------------------------------------------------------------------------
void PathFilm::Start(const FilmState& state, unsigned samples)
{
  if (this->CanContinue(state, samples))
  {
    this->CopySharedArrays();
  }
  else
  {
    this->State = state;
    this->Clear();
  }
}

//------------------------------------------------------------------------------
bool PathFilm::CanContinue(const FilmState& state, unsigned samples) const
{
  return this->Arrays && this->State == state && this->MostSamples <= samples &&
    this->ContentHash() == this->SharedHash;
}

//------------------------------------------------------------------------------
void PathFilm::CopySharedArrays()
{
  vtkPointData* data = this->Arrays->GetPointData();
  for (int i = 0; i < data->GetNumberOfArrays(); ++i)
  {
    vtkDataArray* array = data->GetArray(i);
    if (array->GetReferenceCount() > 1)
    {
      const auto copy = vtkSmartPointer<vtkDataArray>::Take(array->NewInstance());
      copy->DeepCopy(array);
      data->AddArray(copy);
    }
  }
  this->PointToArrays();
}

//------------------------------------------------------------------------------
void PathFilm::Clear()
{
  this->MostSamples = 0;
  // First, so that there is room for the new ones, for which there may be too little memory.
  this->Pixels = {};
  this->Rgba = nullptr;
  this->Arrays = nullptr;
  const auto image = vtkSmartPointer<vtkImageData>::New();
  image->SetExtent(0, this->State.Width - 1, 0, this->State.Height - 1, 0, 0);
  AddPathPictureArrays(image);
  this->Arrays = image;
  this->PointToArrays();
  const std::int64_t pixels = static_cast<std::int64_t>(this->State.Width) * this->State.Height;
  const PathPicture& picture = this->Pixels;
  for (float* three : { picture.Radiance, picture.Albedo, picture.Normal })
  {
    std::fill_n(three, 3 * pixels, 0.0f);
  }
  std::fill_n(picture.Depth, pixels, Miss::Depth);
  std::fill_n(picture.Id, pixels, Miss::Id);
  std::fill_n(picture.Variance, pixels, 0.0f);
  std::fill_n(picture.Coverage, pixels, 0.0f);
  std::fill_n(picture.Samples, pixels, 0u);
}

//------------------------------------------------------------------------------
std::uint64_t PathFilm::ContentHash() const
{
  std::uint64_t hash = 0;
  vtkPointData* data = this->Arrays->GetPointData();
  for (int i = 0; i < data->GetNumberOfArrays(); ++i)
  {
    vtkDataArray* array = data->GetArray(i);
    const std::string name = array->GetName() ? array->GetName() : "";
    hash = MixBits(hash + HashOf(name.data(), name.size()) +
      HashOf(static_cast<const char*>(array->GetVoidPointer(0)),
        static_cast<std::size_t>(array->GetNumberOfValues() * array->GetDataTypeSize())));
  }
  return hash;
}

//------------------------------------------------------------------------------
void PathFilm::PointToArrays()
{
  vtkImageData* image = this->Arrays;
  const int* size = image->GetDimensions();
  this->Pixels = { size[0], size[1], ValuesOf<vtkFloatArray>(image, "radiance"),
    ValuesOf<vtkFloatArray>(image, "albedo"), ValuesOf<vtkFloatArray>(image, "normal"),
    ValuesOf<vtkFloatArray>(image, "depth"), ValuesOf<vtkTypeInt64Array>(image, "sphere_id"),
    ValuesOf<vtkFloatArray>(image, "variance"), ValuesOf<vtkFloatArray>(image, "coverage"),
    ValuesOf<vtkUnsignedIntArray>(image, "samples") };
  this->Rgba = ValuesOf<vtkUnsignedCharArray>(image, "color");
}

//------------------------------------------------------------------------------
void PathFilm::ShareWith(vtkImageData* output)
{
  this->SharedHash = this->ContentHash();
  output->CopyStructure(this->Arrays);
  vtkPointData* data = this->Arrays->GetPointData();
  for (int i = 0; i < data->GetNumberOfArrays(); ++i)
  {
    output->GetPointData()->AddArray(data->GetArray(i));
  }
  output->GetPointData()->SetActiveScalars("color");
}

//------------------------------------------------------------------------------
void PathFilm::SkyBehind(std::int64_t pixel, float (&radiance)[3]) const
{
  const int width = this->Pixels.Width;
  Ray ray = this->State.Rays.At(
    static_cast<double>(pixel % width) + 0.5, static_cast<double>(pixel / width) + 0.5);
  vtkMath::Normalize(ray.D);
  this->State.Light.Sky.Radiance(ray.D, radiance);
}

//------------------------------------------------------------------------------
double PathFilm::CountSamples() const
{
  const std::int64_t pixels = static_cast<std::int64_t>(this->Pixels.Width) * this->Pixels.Height;
  double sum = 0.0;
  for (std::int64_t i = 0; i < pixels; ++i)
  {
    sum += this->Pixels.Samples[i];
  }
  return sum;
}
}
