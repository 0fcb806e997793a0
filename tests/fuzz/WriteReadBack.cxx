// SPDX-License-Identifier: BSD-3-Clause
// Writes any packing in any format and reads it back. Either the writer says in one sentence what
// it cannot write, or the file gives back the same centres and radii, and in the formats that hold
// arrays the same numbers under the same names.
#include "ScratchFile.h"

#include "vtkSpherePackingReader.h"
#include "vtkSpherePackingWriter.h"

#include "vtkCommand.h"
#include "vtkDataArray.h"
#include "vtkDoubleArray.h"
#include "vtkFloatArray.h"
#include "vtkLongLongArray.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkSmartPointer.h"
#include "vtkUnsignedCharArray.h"

#include <fuzzer/FuzzedDataProvider.h>

#include <array>
#include <cmath>
#include <cstdlib>
#include <iostream>
#include <string>

namespace
{
constexpr std::array<const char*, 6> Extensions{ ".spheres", ".xyzr", ".csv", ".xyzd", ".dump",
  ".xyz" };

[[noreturn]] void Fail(const std::string& what)
{
  std::cerr << "FAULT: " << what << std::endl;
  std::abort();
}

class ErrorCounter : public vtkCommand
{
public:
  static ErrorCounter* New() { return new ErrorCounter; }
  void Execute(vtkObject*, unsigned long, void*) override { ++this->Count; }
  int Count = 0;
};

// Half of them any double, half of the kind that packings have.
double TakeNumber(FuzzedDataProvider& data)
{
  if (data.ConsumeBool())
  {
    return data.ConsumeIntegralInRange<int>(-1000, 1000) / 8.0;
  }
  const auto bits = data.ConsumeIntegral<std::uint64_t>();
  double number;
  static_assert(sizeof number == sizeof bits, "a double of 64 bits");
  std::memcpy(&number, &bits, sizeof number);
  return number;
}

vtkSmartPointer<vtkDataArray> MakeArray(int kind)
{
  switch (kind)
  {
    case 0:
      return vtkSmartPointer<vtkDoubleArray>::New();
    case 1:
      return vtkSmartPointer<vtkFloatArray>::New();
    case 2:
      return vtkSmartPointer<vtkLongLongArray>::New();
    default:
      return vtkSmartPointer<vtkUnsignedCharArray>::New();
  }
}

vtkSmartPointer<vtkPolyData> TakePacking(FuzzedDataProvider& data)
{
  auto packing = vtkSmartPointer<vtkPolyData>::New();
  vtkNew<vtkPoints> points;
  const bool single = data.ConsumeBool();
  points->SetDataType(single ? VTK_FLOAT : VTK_DOUBLE);
  const int count = data.ConsumeIntegralInRange<int>(0, 9);
  for (int i = 0; i < count; ++i)
  {
    const double x = TakeNumber(data);
    const double y = TakeNumber(data);
    points->InsertNextPoint(x, y, TakeNumber(data));
  }
  packing->SetPoints(points);
  const int arrays = data.ConsumeIntegralInRange<int>(0, 4);
  for (int a = 0; a <= arrays; ++a)
  {
    const auto array = MakeArray(a == 0 ? (single ? 1 : 0) : data.ConsumeIntegralInRange(0, 3));
    const std::string name = a == 0 ? "radius" : data.ConsumeRandomLengthString(8);
    array->SetName(name.c_str());
    array->SetNumberOfComponents(a == 0 ? 1 : data.ConsumeIntegralInRange(1, 3));
    array->SetNumberOfTuples(count);
    for (vtkIdType i = 0; i < array->GetNumberOfValues(); ++i)
    {
      if (auto* const whole = vtkLongLongArray::SafeDownCast(array))
      {
        whole->SetValue(i, data.ConsumeIntegral<long long>());
        continue;
      }
      const double number = TakeNumber(data);
      const bool byte = array->GetDataType() == VTK_UNSIGNED_CHAR;
      array->SetVariantValue(i,
        byte ? vtkVariant(data.ConsumeIntegral<unsigned char>())
             : vtkVariant(a == 0 ? std::abs(number) : number));
    }
    packing->GetPointData()->AddArray(array);
  }
  return packing;
}

bool SameNumber(vtkDataArray* a, vtkDataArray* b, vtkIdType tuple, int component)
{
  if (a->GetDataType() == VTK_LONG_LONG && b->GetDataType() != VTK_LONG_LONG)
  {
    const vtkVariant left =
      vtkArrayDownCast<vtkLongLongArray>(a)->GetTypedComponent(tuple, component);
    const double right = b->GetComponent(tuple, component);
    return std::abs(right) < 9.2e18 && left.ToLongLong() == static_cast<long long>(right);
  }
  const double left = a->GetComponent(tuple, component);
  const double right = b->GetComponent(tuple, component);
  return left == right || (std::isnan(left) && std::isnan(right));
}

void CheckArray(vtkDataArray* written, vtkDataArray* read, const std::string& what)
{
  if (!read || read->GetNumberOfTuples() != written->GetNumberOfTuples() ||
    read->GetNumberOfComponents() != written->GetNumberOfComponents())
  {
    Fail(what + " has not come back");
  }
  for (vtkIdType i = 0; i < written->GetNumberOfTuples(); ++i)
  {
    for (int k = 0; k < written->GetNumberOfComponents(); ++k)
    {
      if (!SameNumber(written, read, i, k))
      {
        Fail(what + " has come back as other numbers");
      }
    }
  }
}
}

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* bytes, std::size_t size)
{
  FuzzedDataProvider data(bytes, size);
  const std::string extension = Extensions[data.ConsumeIntegralInRange<std::size_t>(0, 5)];
  const std::string path = ScratchPath(extension);
  const auto packing = TakePacking(data);
  vtkNew<ErrorCounter> errors;
  vtkNew<vtkSpherePackingWriter> writer;
  writer->AddObserver(vtkCommand::ErrorEvent, errors);
  writer->SetInputData(packing);
  writer->SetFileName(path.c_str());
  writer->SetSortByRadius(false);
  const bool written = writer->Write() == 1;
  const std::string refusal = writer->GetErrorMessage();
  if (written != refusal.empty() || errors->Count != (written ? 0 : 1))
  {
    Fail("the writer returned " + std::to_string(written) + " and said: " + refusal);
  }
  if (!written)
  {
    return 0;
  }
  vtkNew<vtkSpherePackingReader> reader;
  reader->AddObserver(vtkCommand::ErrorEvent, errors);
  reader->SetFileName(path.c_str());
  const bool single = packing->GetPoints()->GetDataType() == VTK_FLOAT;
  reader->SetOutputPointsPrecision(
    single ? vtkAlgorithm::SINGLE_PRECISION : vtkAlgorithm::DOUBLE_PRECISION);
  reader->Update();
  if (*reader->GetErrorMessage())
  {
    Fail(std::string("what was written cannot be read: ") + reader->GetErrorMessage());
  }
  vtkPolyData* const back = reader->GetOutput();
  CheckArray(packing->GetPoints()->GetData(), back->GetPoints()->GetData(), "the centres");
  vtkPointData* const arrays = packing->GetPointData();
  const bool all = extension == ".csv" || extension == ".dump" || extension == ".xyz";
  for (int i = 0; i < (all ? arrays->GetNumberOfArrays() : 1); ++i)
  {
    const std::string name = arrays->GetArrayName(i);
    CheckArray(
      arrays->GetArray(i), back->GetPointData()->GetArray(name.c_str()), "array '" + name + "'");
  }
  return 0;
}
