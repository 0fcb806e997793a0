// SPDX-License-Identifier: BSD-3-Clause
#include "io/WrittenColumns.h"

#include "bridge/PrintableText.h"
#include "bridge/VectorArrays.h"
#include "io/PackingFileError.h"
#include "io/TableLayout.h"

#include "vtkDataArray.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkStringArray.h"

#include <algorithm>
#include <cstdint>
#include <set>

namespace spherepacking
{
namespace
{
std::string QuotedText(const std::string& text)
{
  return Quote(text.data(), text.data() + text.size());
}

// What separates names, or has another meaning among them.
const char* Separating(Format kind)
{
  return kind == Format::Csv ? ",;\t\"\r\n" : kind == Format::Xyz ? ": \t\"'{}\r\n\\" : " \t\r\n";
}

void CheckName(Format kind, const std::string& name)
{
  if (name.empty())
  {
    throw ContentError("found a point array without a name, expected one, since it goes into the "
                       "header of the file");
  }
  if (name.find_first_of(Separating(kind)) != std::string::npos)
  {
    throw ContentError("the point array " + QuotedText(name) +
      " has a separator, a quote or a line end in its name, expected none, since it goes into the "
      "header of the file");
  }
  if (name.front() == ' ' || name.back() == ' ' || PrintableText(name) != name)
  {
    throw ContentError("the point array " + QuotedText(name) +
      " has a blank at an end of its name, or what is no visible character, expected none, since "
      "it would be read as another name");
  }
}

// Whether double precision holds an integer: all up to 2^53, and others that end in zeros.
bool IsExact(std::uint64_t magnitude)
{
  constexpr std::uint64_t all = std::uint64_t(1) << 53;
  const std::uint64_t lowestBit = magnitude & (~magnitude + 1);
  return magnitude <= all || magnitude / lowestBit <= all;
}

// Numbers in text are read in double precision.
template <typename Integer>
void CheckIntegers(const std::string& name, const Integer* values, vtkIdType count, int components)
{
  for (vtkIdType i = 0; i < count; ++i)
  {
    const auto bits = static_cast<std::uint64_t>(values[i]);
    if (!IsExact(values[i] < 0 ? ~bits + 1 : bits))
    {
      throw ContentError("the point array " + QuotedText(name) + " holds " +
        std::to_string(values[i]) + " at point " + std::to_string(i / components) +
        ", expected integers that double precision holds, as numbers in text are read: .vtp, .vtu "
        "and .vtk hold others");
    }
  }
}

void CheckNumbers(const std::string& name, vtkDataArray* array)
{
  const void* const values = array->GetVoidPointer(0);
  const vtkIdType count = array->GetNumberOfValues();
  const int components = array->GetNumberOfComponents();
  switch (array->GetDataType())
  {
    case VTK_LONG:
      return CheckIntegers(name, static_cast<const long*>(values), count, components);
    case VTK_LONG_LONG:
      return CheckIntegers(name, static_cast<const long long*>(values), count, components);
    case VTK_ID_TYPE:
      return CheckIntegers(name, static_cast<const vtkIdType*>(values), count, components);
    case VTK_UNSIGNED_LONG:
      return CheckIntegers(name, static_cast<const unsigned long*>(values), count, components);
    case VTK_UNSIGNED_LONG_LONG:
      return CheckIntegers(name, static_cast<const unsigned long long*>(values), count, components);
    default: // all values of the others are
      return;
  }
}

// Texts are written as they are: no format but CSV has quotes, and not all read them.
void CheckTexts(Format kind, const WrittenArray& array)
{
  const char* const separating = kind == Format::Csv ? ",;\"#\t\r\n" : " \t\r\n";
  const vtkIdType count = array.Texts->GetNumberOfValues();
  for (vtkIdType i = 0; i < count; ++i)
  {
    const std::string& text = array.Texts->GetValue(i);
    const bool isNumber = kind != Format::Xyz && i == 0 && IsNumber(text);
    if (text.empty() || text.find_first_of(separating) != std::string::npos || isNumber)
    {
      throw ContentError("the point array " + QuotedText(array.Name) + " holds " +
        QuotedText(text) + " at point " + std::to_string(i) + ", expected texts without " +
        (isNumber ? "numbers at the first point, which would be read as numbers"
                  : "separators, and no empty ones"));
    }
  }
}

std::vector<std::string> ColumnsOf(Format kind, const std::string& name, int components)
{
  if (components == 1)
  {
    return { name };
  }
  if (components == 3 && kind == Format::Dump)
  {
    const auto names = ComponentNames(name);
    return { names.begin(), names.end() };
  }
  std::vector<std::string> names;
  for (int i = 0; i < components; ++i)
  {
    names.push_back(name + '_' + std::to_string(i));
  }
  return names;
}

// Whether the reader makes NAME_0, NAME_1 and NAME_2 of a vector NAME that is written. In extended
// XYZ that is one property, of which it makes these parts again.
bool IsProperty(const WriteOptions& options, const std::string& name)
{
  vtkPointData* const data = options.Packing->GetPointData();
  vtkDataArray* const whole = data->GetArray(name.c_str());
  return options.Kind == Format::Xyz && whole && IsMadeOfParts(data, whole) &&
    data->HasArray((name + "_0").c_str()) && data->HasArray((name + "_1").c_str()) &&
    data->HasArray((name + "_2").c_str());
}

bool IsPartOfProperty(const WriteOptions& options, const std::string& name)
{
  const std::size_t end = name.rfind('_');
  return end != std::string::npos && name.size() == end + 2 && name[end + 1] >= '0' &&
    name[end + 1] <= '2' && IsProperty(options, name.substr(0, end));
}

bool IsMadeOfOthers(const WriteOptions& options, vtkDataArray* array)
{
  return IsMadeOfParts(options.Packing->GetPointData(), array) &&
    !IsProperty(options, array->GetName());
}

bool HoldsAllArrays(Format kind)
{
  return kind == Format::Csv || kind == Format::Dump || kind == Format::Xyz;
}

// Whether the format has a place for the array beside centres and radii.
bool IsHeld(const WriteOptions& options, vtkAbstractArray* array)
{
  vtkDataArray* const numbers = vtkDataArray::SafeDownCast(array);
  const std::string name = array->GetName() ? array->GetName() : "";
  if (array == options.Radii || !(numbers || vtkStringArray::SafeDownCast(array)))
  {
    return false;
  }
  if (!HoldsAllArrays(options.Kind))
  {
    return options.Kind == Format::Yade && numbers && name == "matId" &&
      numbers->GetNumberOfComponents() == 1;
  }
  return !numbers || !(IsMadeOfOthers(options, numbers) || IsPartOfProperty(options, name));
}

// Whether readers of extended XYZ take a property for the centres or the radii.
bool IsTakenForAnother(const WrittenArray& array)
{
  std::string name = array.Name;
  std::transform(name.begin(), name.end(), name.begin(),
    [](char c) { return c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c; });
  const auto is = [&name](const char* other) { return name == other; };
  return array.Columns.size() == 3 ? is("pos") || is("position") || is("positions")
                                   : is("radius") || is("radii");
}

// Throws if the reader would take the name of a column for another one, or for the same twice.
void CheckColumns(Format kind, const std::vector<WrittenArray>& arrays)
{
  std::vector<std::string_view> names;
  std::set<std::string_view> properties;
  for (const WrittenArray& array : arrays)
  {
    if (kind == Format::Xyz && !properties.insert(array.Name).second)
    {
      throw ContentError("found the name " + QuotedText(array.Name) + " twice, expected once");
    }
    // The first two are the centres and the radii.
    if (kind == Format::Xyz && &array - arrays.data() >= 2 && IsTakenForAnother(array))
    {
      throw ContentError("found the name " + QuotedText(array.Name) +
        " of an array, expected another one, since it would be read as the centres or the radii");
    }
    names.insert(names.end(), array.Columns.begin(), array.Columns.end());
  }
  std::string complaint;
  if (kind != Format::Xyz && (!ColumnsFromNames(names, complaint) || !complaint.empty()))
  {
    throw ContentError(complaint);
  }
}
}

//------------------------------------------------------------------------------
std::vector<WrittenArray> ChooseArrays(const WriteOptions& options)
{
  const Format kind = options.Kind;
  const char* const radius = HoldsAllArrays(kind) ? "radius" : "r";
  std::vector<WrittenArray> arrays{ { options.Packing->GetPoints()->GetData(), nullptr, "pos",
                                      { "x", "y", "z" } },
    { options.Radii, nullptr, radius, { radius } } };
  vtkPointData* const data = options.Packing->GetPointData();
  for (int i = 0; i < data->GetNumberOfArrays(); ++i)
  {
    vtkAbstractArray* const array = data->GetAbstractArray(i);
    if (IsHeld(options, array))
    {
      const std::string name = array->GetName() ? array->GetName() : "";
      arrays.push_back({ vtkDataArray::SafeDownCast(array), vtkStringArray::SafeDownCast(array),
        name, ColumnsOf(kind, name, array->GetNumberOfComponents()) });
    }
  }
  for (const WrittenArray& array : arrays)
  {
    CheckName(kind, array.Name);
    if (array.Texts)
    {
      CheckTexts(kind, array);
    }
    else
    {
      CheckNumbers(array.Name, array.Numbers);
    }
  }
  CheckColumns(kind, arrays);
  if (kind == Format::Xyz)
  {
    std::stable_partition(
      arrays.begin(), arrays.end(), [](const WrittenArray& array) { return array.Texts; });
  }
  return arrays;
}
}
