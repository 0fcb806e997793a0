// SPDX-License-Identifier: BSD-3-Clause
#include "io/FileBytes.h"
#include "io/Number.h"
#include "io/PackingFileError.h"
#include "io/PackingFormats.h"
#include "io/Separators.h"
#include "io/TextLines.h"

#include "vtkByteSwap.h"
#include "vtkErrorCode.h"
#include "vtksys/SystemTools.hxx"

#include <algorithm>
#include <atomic>
#include <cmath>
#include <cstring>
#include <limits>
#include <string_view>

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

[[noreturn]] void ThrowBadSphere(
  const std::string& file, vtkIdType index, const double (&sphere)[4], bool single)
{
  const char* const names[] = { "x", "y", "z", "diameter" };
  int part = 0;
  const double limit =
    single ? double{ std::numeric_limits<float>::max() } : std::numeric_limits<double>::max();
  while (part < 3 && std::abs(sphere[part]) <= limit)
  {
    ++part;
  }
  throw PackingFileError(vtkErrorCode::FileFormatError,
    file + ", sphere " + std::to_string(index + 1) + ": found " + NumberText(sphere[part]) +
      " as " + names[part] + ", expected a finite number" +
      (part == 3 ? " that is not negative" : "") + (single ? " of single precision" : ""));
}

template <typename Real>
void Unpack(const ReadOptions& options, const FileBytes& bytes, double scale, PackingArrays& arrays,
  Progress& progress)
{
  Real* const centres = arrays.Centers<Real>();
  Real* const radii = arrays.Radii<Real>();
  constexpr vtkIdType none = std::numeric_limits<vtkIdType>::max();
  std::atomic<vtkIdType> firstBad{ none };
  const auto unpack = [&](vtkIdType first, vtkIdType last)
  {
    for (vtkIdType i = first; i < last; ++i)
    {
      double sphere[4];
      LoadSphere(bytes.Begin() + i * SphereBytes, sphere);
      Real* const centre = centres + 3 * i;
      for (int axis = 0; axis < 3; ++axis)
      {
        centre[axis] = static_cast<Real>(sphere[axis]);
      }
      radii[i] = static_cast<Real>(0.5 * sphere[3] * scale);
      if (!std::isfinite(centre[0]) || !std::isfinite(centre[1]) || !std::isfinite(centre[2]) ||
        !std::isfinite(radii[i]) || radii[i] < 0)
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
      ThrowBadSphere(options.File, firstBad, sphere, options.Single);
    }
  };
  ForInBatches(arrays.GetCount(), 1 << 14, progress, unpack, check);
}
}

//------------------------------------------------------------------------------
namespace
{
// Whether all bytes are printed characters or blanks, which those of four float64 hardly ever are.
bool LooksLikeText(const FileBytes& head)
{
  return std::all_of(head.Begin(), head.End(),
    [](char c) { return (c >= ' ' && c <= '~') || c == '\t' || IsLineEnd(c); });
}

// The number after `label`, with blanks around it.
double Porosity(const std::string& file, const FileBytes& bytes, std::string_view label)
{
  const std::string_view text(bytes.Begin(), bytes.End() - bytes.Begin());
  const std::size_t at = text.find(label);
  const std::string expected =
    " for '" + std::string(label) + "', expected a number from 0 to below 1";
  if (at == text.npos)
  {
    throw PackingFileError(vtkErrorCode::FileFormatError, file + ": found no such line" + expected);
  }
  const char* first = SkipBlanks(text.data() + at + label.size(), bytes.End());
  const char* last =
    std::find_if(first, bytes.End(), [](char c) { return IsBlank(c) || IsLineEnd(c); });
  double porosity = -1.0;
  if (ParseNumber(first, bytes.End(), porosity) != last || !(porosity >= 0.0 && porosity < 1.0))
  {
    ThrowAtLine(
      file, 1 + CountLineEnds(bytes.Begin(), first), "found " + Quote(first, last) + expected);
  }
  return porosity;
}
}

//------------------------------------------------------------------------------
double DiameterScale(const std::string& xyzdFile)
{
  using vtksys::SystemTools;
  const std::string path = SystemTools::GetFilenamePath(xyzdFile);
  const std::string name = SystemTools::GetFilenameWithoutLastExtension(xyzdFile) + ".nfo";
  const std::string file = path.empty() ? name : path + "/" + name;
  if (!SystemTools::FileExists(file, true))
  {
    return 1.0;
  }
  if (SystemTools::FileLength(file) == 0)
  {
    throw PackingFileError(
      vtkErrorCode::FileFormatError, file + ": the file is empty, expected two porosities");
  }
  const FileBytes bytes = FileBytes::ReadHead(file, 1 << 16);
  const auto find = [&](std::string_view label) { return Porosity(file, bytes, label); };
  // V. Baranau and U. Tallarek, "Random-close packing limits for monodisperse and polydisperse
  // hard spheres", 2014, whose program stores the diameters before its last rescaling.
  return std::cbrt((1.0 - find("Final Porosity:")) / (1.0 - find("Theoretical Porosity:")));
}

//------------------------------------------------------------------------------
PackingArrays ReadXyzd(const ReadOptions& options, Progress& progress)
{
  const unsigned long long size = FileBytes::Size(options.File);
  if (size % SphereBytes != 0)
  {
    throw PackingFileError(vtkErrorCode::PrematureEndOfFileError,
      options.File + ": found " + std::to_string(size) + " bytes, which end within sphere " +
        std::to_string(size / SphereBytes + 1) +
        ", expected a multiple of 32: x y z diameter as float64");
  }
  if (LooksLikeText(FileBytes::ReadHead(options.File, SphereBytes)))
  {
    throw PackingFileError(vtkErrorCode::FileFormatError,
      options.File + ": found text, expected x y z diameter as float64, 32 bytes a sphere");
  }
  const double scale = DiameterScale(options.File);
  progress.SetRange(0.0, 0.5);
  const FileBytes bytes = FileBytes::ReadRange(options.File, 0, size, progress);
  PackingArrays arrays(static_cast<vtkIdType>(size / SphereBytes), options.Single);
  progress.SetRange(0.5, 1.0);
  if (options.Single)
  {
    Unpack<float>(options, bytes, scale, arrays, progress);
  }
  else
  {
    Unpack<double>(options, bytes, scale, arrays, progress);
  }
  return arrays;
}
}
