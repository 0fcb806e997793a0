// SPDX-License-Identifier: BSD-3-Clause
#include "io/WritePacking.h"

#include "io/AtomicFile.h"
#include "io/Number.h"
#include "io/PackingFileError.h"
#include "io/TableLayout.h"

#include "vtkByteSwap.h"
#include "vtkDataArray.h"
#include "vtkErrorCode.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace spherepacking
{
namespace
{
/// A column of the file: a component of an array.
struct WrittenColumn
{
  vtkDataArray* Array;
  int Component;
  std::string Name;
};

// A name as a field of a CSV header.
std::string CsvField(const std::string& name)
{
  if (name.find_first_of(",;\t\"\r\n") == std::string::npos)
  {
    return name;
  }
  throw ContentError("the point array " + Quote(name.data(), name.data() + name.size()) +
    " has a separator, a quote or a line end in its name, expected none, since it goes into the "
    "header of a CSV file");
}

// The centre, the radius and the point arrays that the format can hold.
std::vector<WrittenColumn> ChooseColumns(const WriteOptions& options)
{
  vtkDataArray* centers = options.Packing->GetPoints()->GetData();
  std::vector<WrittenColumn> columns{ { centers, 0, "x" }, { centers, 1, "y" }, { centers, 2, "z" },
    { options.Radii, 0, options.Kind == Format::Csv ? "radius" : "r" } };
  vtkPointData* data = options.Packing->GetPointData();
  for (int i = 0; i < data->GetNumberOfArrays(); ++i)
  {
    vtkDataArray* array = data->GetArray(i);
    if (!array || array == options.Radii || !array->GetName())
    {
      continue;
    }
    const std::string name = array->GetName();
    const int components = array->GetNumberOfComponents();
    if (options.Kind == Format::Yade && name == "matId" && components == 1)
    {
      columns.push_back({ array, 0, name });
    }
    for (int c = 0; options.Kind == Format::Csv && c < components; ++c)
    {
      columns.push_back(
        { array, c, CsvField(components == 1 ? name : name + "_" + std::to_string(c)) });
    }
  }
  return columns;
}

// Throws if the reader would take the name of an array for another column, or for the same twice.
void CheckNames(const std::vector<WrittenColumn>& columns)
{
  std::vector<std::string_view> names;
  for (const WrittenColumn& column : columns)
  {
    names.emplace_back(column.Name);
  }
  std::string complaint;
  if (!ColumnsFromNames(names, complaint) || !complaint.empty())
  {
    throw ContentError(complaint);
  }
}

std::string Header(const WriteOptions& options, const std::vector<WrittenColumn>& columns)
{
  if (options.Kind != Format::Csv && options.Kind != Format::Yade)
  {
    return {};
  }
  const bool csv = options.Kind == Format::Csv;
  std::string text = csv ? "" : "#format ";
  for (const WrittenColumn& column : columns)
  {
    text += (&column == &columns.front() ? "" : csv ? "," : "_") + column.Name;
  }
  return text + '\n';
}

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
  std::string& text, const std::vector<WrittenColumn>& columns, vtkIdType sphere, char separator)
{
  char number[MaximumNumberLength + 1];
  for (const WrittenColumn& column : columns)
  {
    char* end = WriteNumber(number, column.Array->GetComponent(sphere, column.Component));
    *end = &column == &columns.back() ? '\n' : separator;
    text.append(number, end + 1);
  }
}

void AppendBytes(std::string& bytes, const std::vector<WrittenColumn>& columns, vtkIdType sphere)
{
  double values[4];
  for (int i = 0; i < 4; ++i)
  {
    values[i] = columns[i].Array->GetComponent(sphere, columns[i].Component);
  }
  values[3] *= 2.0;
  if (!std::isfinite(values[3]))
  {
    throw ContentError("found the radius " + NumberText(columns[3].Array->GetComponent(sphere, 0)) +
      " at point " + std::to_string(sphere) + ", expected one whose diameter is finite");
  }
  vtkByteSwap::SwapLERange(values, 4);
  bytes.append(reinterpret_cast<const char*>(values), sizeof(values));
}

// Writes the header and all spheres into `file`, a batch at a time.
void WriteSpheres(const WriteOptions& options, const std::vector<WrittenColumn>& columns,
  AtomicFile& file, Progress& progress)
{
  const std::vector<vtkIdType> order = LargestFirst(options);
  const vtkIdType count = options.Packing->GetNumberOfPoints();
  std::string buffer = Header(options, columns);
  constexpr vtkIdType batch = 1 << 14;
  for (vtkIdType i = 0; i < count; ++i)
  {
    const vtkIdType sphere = order.empty() ? i : order[i];
    if (options.Kind == Format::Xyzd)
    {
      AppendBytes(buffer, columns, sphere);
    }
    else
    {
      AppendText(buffer, columns, sphere, options.Kind == Format::Csv ? ',' : ' ');
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
void CheckDiameterScale(const std::string& file)
{
  const double scale = DiameterScale(file);
  if (scale != 1.0)
  {
    throw PackingFileError(vtkErrorCode::CannotOpenFileError,
      file + ": found beside it an .nfo file that scales the diameters by " + NumberText(scale) +
        ", expected none, or one that leaves them");
  }
}
}

//------------------------------------------------------------------------------
void WritePacking(const std::string& file, const WriteOptions& options, Progress& progress)
{
  if (options.Kind == Format::Xyzd)
  {
    CheckDiameterScale(file);
  }
  const auto write = [&]
  {
    const std::vector<WrittenColumn> columns = ChooseColumns(options);
    CheckNames(columns);
    AtomicFile target(file);
    WriteSpheres(options, columns, target, progress);
    target.Commit();
  };
  WithFileName(file, write);
}
}
