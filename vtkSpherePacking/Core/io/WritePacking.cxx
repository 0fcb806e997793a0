// SPDX-License-Identifier: BSD-3-Clause
#include "io/WritePacking.h"

#include "io/AtomicFile.h"
#include "io/Number.h"
#include "io/PackingFileError.h"
#include "io/WriteHeader.h"
#include "io/WrittenColumns.h"

#include "vtkByteSwap.h"
#include "vtkDataArray.h"
#include "vtkErrorCode.h"
#include "vtkPolyData.h"
#include "vtkStringArray.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <optional>

namespace spherepacking
{
namespace
{
// The order of the spheres in the file; empty if that is the order of the points.
std::vector<vtkIdType> LargestFirst(const WriteOptions& options)
{
  std::vector<vtkIdType> order;
  if (options.Kind == Format::Spheres && options.SortByRadius)
  {
    const vtkIdType count = options.Packing->GetNumberOfPoints();
    std::vector<double> radii(count);
    for (vtkIdType i = 0; i < count; ++i)
    {
      radii[i] = options.Radii->GetComponent(i, 0);
    }
    order.resize(count);
    std::iota(order.begin(), order.end(), 0);
    std::stable_sort(order.begin(), order.end(),
      [&radii](vtkIdType a, vtkIdType b) { return radii[a] > radii[b]; });
  }
  return order;
}

void AppendText(
  std::string& text, const std::vector<WrittenArray>& arrays, vtkIdType sphere, char separator)
{
  char number[MaximumNumberLength];
  for (const WrittenArray& array : arrays)
  {
    const int columns = static_cast<int>(array.Columns.size());
    for (int c = 0; c < columns; ++c)
    {
      if (array.Texts)
      {
        text += array.Texts->GetValue(sphere * columns + c);
      }
      else
      {
        text.append(number, WriteNumber(number, array.Numbers->GetComponent(sphere, c)));
      }
      text += separator;
    }
  }
  text.back() = '\n';
}

void AppendBytes(std::string& bytes, const WriteOptions& options, vtkIdType sphere)
{
  double values[4];
  options.Packing->GetPoint(sphere, values);
  const double radius = options.Radii->GetComponent(sphere, 0);
  values[3] = 2.0 * radius;
  if (!std::isfinite(values[3]))
  {
    throw ContentError("found the radius " + NumberText(radius) + " at point " +
      std::to_string(sphere) + ", expected one whose diameter is finite");
  }
  vtkByteSwap::SwapLERange(values, 4);
  bytes.append(reinterpret_cast<const char*>(values), sizeof(values));
}

// Writes the header and all spheres into `file`, a batch at a time.
void WriteSpheres(const WriteOptions& options, const std::vector<WrittenArray>& arrays,
  AtomicFile& file, Progress& progress)
{
  const std::vector<vtkIdType> order = LargestFirst(options);
  const vtkIdType count = options.Packing->GetNumberOfPoints();
  std::string buffer = HeaderOf(options, arrays);
  constexpr vtkIdType batch = 1 << 14;
  for (vtkIdType i = 0; i < count; ++i)
  {
    const vtkIdType sphere = order.empty() ? i : order[i];
    if (options.Kind == Format::Xyzd)
    {
      AppendBytes(buffer, options, sphere);
    }
    else
    {
      AppendText(buffer, arrays, sphere, options.Kind == Format::Csv ? ',' : ' ');
    }
    if ((i + 1) % batch == 0 || i + 1 == count)
    {
      file.Write(buffer.data(), buffer.size());
      buffer.clear();
      progress.Report(static_cast<double>(i + 1) / static_cast<double>(count));
    }
  }
}

// The reader would multiply the diameters by the scale of an .nfo file beside the file.
void CheckDiameterScale(const std::string& file, std::optional<vtkIdType> count)
{
  const double scale = DiameterScale(file, count);
  if (scale != 1.0)
  {
    throw PackingFileError(vtkErrorCode::CannotOpenFileError,
      file + ": found beside it an .nfo file that scales the diameters by " + NumberText(scale) +
        ", expected none, or one that leaves them");
  }
}

void CheckFormat(const std::string& file, Format kind, std::optional<vtkIdType> count)
{
  if (!((kind >= Format::Spheres && kind <= Format::Dump) || kind == Format::Xyz))
  {
    throw PackingFileError(vtkErrorCode::UnrecognizedFileTypeError,
      file +
        ": found a format that cannot be written, expected the extension .spheres, "
        ".xyzr, .txt, .csv, .xyzd, .dump or .xyz; spherepacking.write() writes .vtp, .vtu and "
        ".vtk, too");
  }
  if (kind == Format::Xyzd)
  {
    CheckDiameterScale(file, count);
  }
}
}

//------------------------------------------------------------------------------
void CheckWritable(const std::string& file, Format kind)
{
  CheckFormat(file, kind, std::nullopt);
  const AtomicFile target(file);
}

//------------------------------------------------------------------------------
void WritePacking(const std::string& file, const WriteOptions& options, Progress& progress)
{
  CheckFormat(file, options.Kind, options.Packing->GetNumberOfPoints());
  const auto write = [&]
  {
    const std::vector<WrittenArray> arrays = ChooseArrays(options);
    AtomicFile target(file);
    WriteSpheres(options, arrays, target, progress);
    target.Commit();
  };
  WithFileName(file, write);
}
}
