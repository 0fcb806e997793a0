// SPDX-License-Identifier: BSD-3-Clause
#include "vtkSpherePackingPathState.h"

#include "vtkSpherePackingPicture.h"

#include "kernels/MixBits.h"

#include "vtkDataArray.h"
#include "vtkFloatArray.h"
#include "vtkImageData.h"
#include "vtkMath.h"
#include "vtkPointData.h"
#include "vtkSMPTools.h"
#include "vtkTypeInt64Array.h"
#include "vtkUnsignedCharArray.h"
#include "vtkUnsignedIntArray.h"

#include <algorithm>
#include <atomic>
#include <cmath>
#include <cstring>
#include <limits>

VTK_ABI_NAMESPACE_BEGIN
namespace
{
template <typename ArrayT>
auto* ValuesOf(vtkImageData* image, const char* name)
{
  return ArrayT::SafeDownCast(image->GetPointData()->GetArray(name))->GetPointer(0);
}

// Of bytes; changes when any of them does, but for a chance of 2^-64.
std::uint64_t DigestOf(const char* bytes, std::size_t length)
{
  constexpr std::size_t part = 1 << 16;
  std::atomic<std::uint64_t> sum{ 0 };
  vtkSMPTools::For(0, static_cast<vtkIdType>((length + part - 1) / part), 16,
    [&](vtkIdType first, vtkIdType last)
    {
      for (vtkIdType i = first; i < last; ++i)
      {
        const std::size_t begin = static_cast<std::size_t>(i) * part;
        const std::size_t end = std::min(begin + part, length);
        std::uint64_t lanes[4] = { 1, 2, 3, static_cast<std::uint64_t>(i) };
        for (std::size_t at = begin; at < end; at += sizeof(lanes))
        {
          std::uint64_t words[4] = {};
          std::memcpy(words, bytes + at, std::min(sizeof(words), end - at));
          for (int lane = 0; lane < 4; ++lane)
          {
            lanes[lane] = (lanes[lane] ^ words[lane]) * 0x9e3779b97f4a7c15u;
            lanes[lane] ^= lanes[lane] >> 29;
          }
        }
        std::uint64_t all = 0;
        for (const std::uint64_t lane : lanes)
        {
          all = spherepacking::MixBits(all ^ lane);
        }
        sum += all;
      }
    });
  return sum;
}
}

//------------------------------------------------------------------------------
void vtkSpherePackingPathState::Begin(
  const std::string& key, const int (&size)[2], unsigned samples)
{
  if (this->Arrays && this->Key == key && this->Most <= samples && this->Digest() == this->Shared)
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
    this->Point();
    return;
  }
  this->Key = key;
  this->Most = 0;
  // First, so that there is room for the new ones.
  this->Arrays = nullptr;
  const auto image = vtkSmartPointer<vtkImageData>::New();
  image->SetExtent(0, size[0] - 1, 0, size[1] - 1, 0, 0);
  vtkSpherePackingAddPathPicture(image);
  this->Arrays = image;
  this->Point();
  const std::int64_t pixels = static_cast<std::int64_t>(size[0]) * size[1];
  const spherepacking::PathPicture& picture = this->Picture;
  for (float* three : { picture.Radiance, picture.Albedo, picture.Normal })
  {
    std::fill_n(three, 3 * pixels, 0.0f);
  }
  std::fill_n(picture.Depth, pixels, std::numeric_limits<float>::infinity());
  std::fill_n(picture.Id, pixels, -1);
  std::fill_n(picture.Variance, pixels, 0.0f);
  std::fill_n(picture.Coverage, pixels, 0.0f);
  std::fill_n(picture.Samples, pixels, 0u);
}

//------------------------------------------------------------------------------
std::uint64_t vtkSpherePackingPathState::Digest() const
{
  std::uint64_t digest = 0;
  vtkPointData* data = this->Arrays->GetPointData();
  for (int i = 0; i < data->GetNumberOfArrays(); ++i)
  {
    vtkDataArray* array = data->GetArray(i);
    const std::string name = array->GetName() ? array->GetName() : "";
    digest = spherepacking::MixBits(digest + DigestOf(name.data(), name.size()) +
      DigestOf(static_cast<const char*>(array->GetVoidPointer(0)),
        static_cast<std::size_t>(array->GetNumberOfValues() * array->GetDataTypeSize())));
  }
  return digest;
}

//------------------------------------------------------------------------------
void vtkSpherePackingPathState::Point()
{
  vtkImageData* image = this->Arrays;
  const int* size = image->GetDimensions();
  this->Picture = { size[0], size[1], ValuesOf<vtkFloatArray>(image, "radiance"),
    ValuesOf<vtkFloatArray>(image, "albedo"), ValuesOf<vtkFloatArray>(image, "normal"),
    ValuesOf<vtkFloatArray>(image, "depth"), ValuesOf<vtkTypeInt64Array>(image, "sphere_id"),
    ValuesOf<vtkFloatArray>(image, "variance"), ValuesOf<vtkFloatArray>(image, "coverage"),
    ValuesOf<vtkUnsignedIntArray>(image, "samples") };
  this->Color = ValuesOf<vtkUnsignedCharArray>(image, "color");
}

//------------------------------------------------------------------------------
void vtkSpherePackingPathState::Share(vtkImageData* output)
{
  this->Shared = this->Digest();
  output->CopyStructure(this->Arrays);
  vtkPointData* data = this->Arrays->GetPointData();
  for (int i = 0; i < data->GetNumberOfArrays(); ++i)
  {
    output->GetPointData()->AddArray(data->GetArray(i));
  }
  output->GetPointData()->SetActiveScalars("color");
}

//------------------------------------------------------------------------------
void vtkSpherePackingPathState::SeeSky(std::int64_t pixel, float (&radiance)[3]) const
{
  const int width = this->Picture.Width;
  spherepacking::Ray ray = this->Rays.At(
    static_cast<double>(pixel % width) + 0.5, static_cast<double>(pixel / width) + 0.5);
  vtkMath::Normalize(ray.D);
  this->From.Radiance(ray.D, radiance);
}

//------------------------------------------------------------------------------
double vtkSpherePackingPathState::CountSamples() const
{
  const std::int64_t pixels = static_cast<std::int64_t>(this->Picture.Width) * this->Picture.Height;
  double sum = 0.0;
  for (std::int64_t i = 0; i < pixels; ++i)
  {
    sum += this->Picture.Samples[i];
  }
  return sum;
}

//------------------------------------------------------------------------------
vtkSpherePackingPathCells::vtkSpherePackingPathCells(const spherepacking::PathPicture& picture)
  : Picture(picture)
  , Columns((picture.Width - 1) / spherepacking::PathCells::Side + 1)
  , Rows((picture.Height - 1) / spherepacking::PathCells::Side + 1)
  , Active(static_cast<std::size_t>(this->Columns) * this->Rows, 1)
{
}

//------------------------------------------------------------------------------
void vtkSpherePackingPathCells::LeaveOut(unsigned samples, double target)
{
  for (int row = 0; row < this->Rows; ++row)
  {
    for (int column = 0; column < this->Columns; ++column)
    {
      unsigned char& active = this->Active[static_cast<std::size_t>(row) * this->Columns + column];
      active = active && !this->IsDone(column, row, samples, target);
    }
  }
}

//------------------------------------------------------------------------------
bool vtkSpherePackingPathCells::IsDone(int column, int row, unsigned samples, double target) const
{
  constexpr int side = spherepacking::PathCells::Side;
  double variance = 0.0;
  double brightness = 0.0;
  int number = 0;
  for (int y = row * side; y < std::min((row + 1) * side, this->Picture.Height); ++y)
  {
    for (int x = column * side; x < std::min((column + 1) * side, this->Picture.Width); ++x)
    {
      const std::int64_t pixel = static_cast<std::int64_t>(y) * this->Picture.Width + x;
      if (this->Picture.Samples[pixel] != samples)
      {
        return false;
      }
      variance += this->Picture.Variance[pixel];
      brightness += spherepacking::Brightness(this->Picture.Radiance + 3 * pixel);
      ++number;
    }
  }
  return std::sqrt(variance / number) <= target * brightness / number;
}

//------------------------------------------------------------------------------
bool vtkSpherePackingPathCells::Any() const
{
  return std::find(this->Active.begin(), this->Active.end(), 1) != this->Active.end();
}
VTK_ABI_NAMESPACE_END
