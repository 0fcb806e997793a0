// SPDX-License-Identifier: BSD-3-Clause
#include "io/WriteHeader.h"

#include "bridge/PackingCell.h"
#include "io/DumpBox.h"
#include "io/Number.h"
#include "io/PackingFileError.h"

#include "vtkDataArray.h"
#include "vtkFieldData.h"
#include "vtkPolyData.h"

#include <cmath>
#include <optional>
#include <stdexcept>

namespace spherepacking
{
namespace
{
// Up to which a double counts, and a file of another program holds.
constexpr double LargestStep = 9007199254740992.0;

std::string JoinColumns(const std::vector<WrittenArray>& arrays, const char* separator)
{
  std::string text;
  for (const WrittenArray& array : arrays)
  {
    for (const std::string& column : array.Columns)
    {
      text += (text.empty() ? "" : separator) + column;
    }
  }
  return text;
}

std::optional<double> TimeOf(const WriteOptions& options)
{
  vtkDataArray* const array = options.Packing->GetFieldData()->GetArray("TimeValue");
  if (!array || array->GetNumberOfValues() == 0)
  {
    return std::nullopt;
  }
  const double time = array->GetComponent(0, 0);
  if (!std::isfinite(time))
  {
    throw ContentError("TimeValue: found " + NumberText(time) + ", expected a finite number");
  }
  return time;
}

std::optional<SimulationCell> CellOf(const WriteOptions& options)
{
  try
  {
    return FindCell(options.Packing);
  }
  catch (const std::invalid_argument& error)
  {
    throw ContentError(error.what());
  }
}

std::string JoinNumbers(const double* values, int count)
{
  std::string text;
  for (int i = 0; i < count; ++i)
  {
    text += (i > 0 ? " " : "") + NumberText(values[i]);
  }
  return text;
}

std::string DumpHeader(const WriteOptions& options, const std::vector<WrittenArray>& arrays)
{
  const std::optional<SimulationCell> cell = CellOf(options);
  const double time = TimeOf(options).value_or(0.0);
  // Steps are counted: LAMMPS and others read whole numbers there. A reader that knows ITEM: TIME
  // takes that.
  const bool isStep = time == std::floor(time) && std::abs(time) <= LargestStep;
  return (isStep ? "" : "ITEM: TIME\n" + NumberText(time) + '\n') + "ITEM: TIMESTEP\n" +
    NumberText(isStep ? time : 0.0) + "\nITEM: NUMBER OF ATOMS\n" +
    std::to_string(options.Packing->GetNumberOfPoints()) + '\n' + (cell ? BoxOfCell(*cell) : "") +
    "ITEM: ATOMS " + JoinColumns(arrays, " ") + '\n';
}

// Of extended XYZ: KEY=VALUE, and NAME:TYPE:COLUMNS of each array, of the types S for texts, I for
// integers and R for real numbers.
std::string XyzHeader(const WriteOptions& options, const std::vector<WrittenArray>& arrays)
{
  std::string text = std::to_string(options.Packing->GetNumberOfPoints()) + '\n';
  if (const std::optional<SimulationCell> cell = CellOf(options))
  {
    text += "Lattice=\"" + JoinNumbers(cell->Vectors[0], 9) + "\" Origin=\"" +
      JoinNumbers(cell->Origin, 3) + "\" pbc=\"";
    for (int i = 0; i < 3; ++i)
    {
      text += std::string(i > 0 ? " " : "") + (cell->Periodic[i] ? 'T' : 'F');
    }
    text += "\" ";
  }
  if (const std::optional<double> time = TimeOf(options))
  {
    text += "Time=" + NumberText(*time) + ' ';
  }
  text += "Properties=";
  for (const WrittenArray& array : arrays)
  {
    const bool isReal = array.Numbers &&
      (array.Numbers->GetDataType() == VTK_DOUBLE || array.Numbers->GetDataType() == VTK_FLOAT);
    text += (&array == &arrays.front() ? "" : ":") + array.Name + ':' +
      (array.Texts ? 'S'
          : isReal ? 'R'
                   : 'I') +
      ':' + std::to_string(array.Columns.size());
  }
  return text + '\n';
}
}

//------------------------------------------------------------------------------
std::string HeaderOf(const WriteOptions& options, const std::vector<WrittenArray>& arrays)
{
  return options.Kind == Format::Csv ? JoinColumns(arrays, ",") + '\n'
    : options.Kind == Format::Yade   ? "#format " + JoinColumns(arrays, "_") + '\n'
    : options.Kind == Format::Dump   ? DumpHeader(options, arrays)
    : options.Kind == Format::Xyz    ? XyzHeader(options, arrays)
                                     : "";
}
}
