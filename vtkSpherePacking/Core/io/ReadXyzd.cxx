// SPDX-License-Identifier: BSD-3-Clause
#include "io/FileBytes.h"
#include "io/Number.h"
#include "io/PackingFileError.h"
#include "io/PackingFormats.h"
#include "io/TextLines.h"

#include "vtkByteSwap.h"
#include "vtkErrorCode.h"

#include <algorithm>
#include <atomic>
#include <cmath>
#include <cstring>
#include <limits>

namespace spherepacking
{
namespace
{
constexpr std::size_t SphereBytes = 4 * sizeof(double);

void LoadSphere(const char* bytes, double (&sphere)[4])
{
  std::memcpy(sphere, bytes, SphereBytes);
  vtkByteSwap::Swap8LERange(sphere, 4);
}

[[noreturn]] void ThrowBadSphere(vtkIdType index, const double (&sphere)[4], bool single)
{
  const char* const names[] = { "x", "y", "z", "diameter" };
  int component = 0;
  const double limit =
    single ? double{ std::numeric_limits<float>::max() } : std::numeric_limits<double>::max();
  while (component < 3 && std::abs(sphere[component]) <= limit)
  {
    ++component;
  }
  throw ContentError("found " + NumberText(sphere[component]) + " as " + names[component] +
      ", expected a finite number" + (component == 3 ? " that is not negative" : "") +
      (single ? " of single precision" : ""),
    "sphere " + std::to_string(index + 1));
}

template <typename Real>
void Unpack(const FileBytes& bytes, double scale, PackingArrays& arrays, Progress& progress)
{
  Real* const centers = arrays.Centers<Real>();
  Real* const radii = arrays.Radii<Real>();
  constexpr vtkIdType none = std::numeric_limits<vtkIdType>::max();
  std::atomic<vtkIdType> firstBad{ none };
  const auto unpack = [&](vtkIdType first, vtkIdType last)
  {
    for (vtkIdType i = first; i < last; ++i)
    {
      double sphere[4];
      LoadSphere(bytes.Begin() + i * SphereBytes, sphere);
      Real* const center = centers + 3 * i;
      for (int axis = 0; axis < 3; ++axis)
      {
        center[axis] = static_cast<Real>(sphere[axis]);
      }
      radii[i] = static_cast<Real>(0.5 * sphere[3] * scale);
      if (!std::isfinite(center[0]) || !std::isfinite(center[1]) || !std::isfinite(center[2]) ||
        !std::isfinite(radii[i]) || sphere[3] < 0)
      {
        vtkIdType seen = firstBad;
        while (i < seen && !firstBad.compare_exchange_weak(seen, i))
        {
        }
        return;
      }
    }
  };
  const auto check = [&]
  {
    if (firstBad != none)
    {
      double sphere[4];
      LoadSphere(bytes.Begin() + firstBad * SphereBytes, sphere);
      ThrowBadSphere(firstBad, sphere, arrays.IsSingle());
    }
  };
  ForInBatches(arrays.GetCount(), 1 << 14, progress, unpack, check);
}

// Whether all bytes are printed characters or blanks, which those of four float64 hardly ever are.
bool LooksLikeText(const FileBytes& head)
{
  return std::all_of(head.Begin(), head.End(),
    [](char c) { return (c >= ' ' && c <= '~') || c == '\t' || IsLineEnd(c); });
}

PackingArrays ParseXyzd(
  const FileBytes& bytes, double scale, const ReadOptions& options, Progress& progress)
{
  const auto count = static_cast<vtkIdType>((bytes.End() - bytes.Begin()) / SphereBytes);
  PackingArrays arrays(count, options.Single);
  progress.SetRange(0.5, 1.0);
  if (options.Single)
  {
    Unpack<float>(bytes, scale, arrays, progress);
  }
  else
  {
    Unpack<double>(bytes, scale, arrays, progress);
  }
  return arrays;
}
}

//------------------------------------------------------------------------------
PackingArrays ReadXyzd(const std::string& file, const ReadOptions& options, Progress& progress)
{
  const unsigned long long size = FileBytes::Size(file);
  if (size % SphereBytes != 0)
  {
    throw PackingFileError(vtkErrorCode::PrematureEndOfFileError,
      file + ": found " + std::to_string(size) + " bytes, which end within sphere " +
        std::to_string(size / SphereBytes + 1) +
        ", expected a multiple of 32: x y z diameter as float64");
  }
  if (LooksLikeText(FileBytes::ReadHead(file, SphereBytes)))
  {
    throw PackingFileError(vtkErrorCode::FileFormatError,
      file + ": found text, expected x y z diameter as float64, 32 bytes a sphere");
  }
  const double scale = DiameterScale(file, static_cast<vtkIdType>(size / SphereBytes));
  progress.SetRange(0.0, 0.5);
  const FileBytes bytes = FileBytes::ReadRange(file, 0, size, progress);
  return WithFileName(file, [&] { return ParseXyzd(bytes, scale, options, progress); });
}
}
