// SPDX-License-Identifier: BSD-3-Clause
// Reads any bytes as a packing of any format. Whatever they are: either there is an error of one
// sentence and nothing else, or a packing whose arrays are whole and whose radii are numbers >= 0;
// and it is the same however the file is cut into chunks, and in single precision.
#include "ScratchFile.h"

#include "vtkSpherePackingReader.h"

#include "vtkAbstractArray.h"
#include "vtkCommand.h"
#include "vtkDataArray.h"
#include "vtkInformation.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkStreamingDemandDrivenPipeline.h"

#include <array>
#include <cmath>
#include <cstdlib>
#include <iostream>
#include <string>

namespace
{
struct Extension
{
  const char* Text;
  int Format;
};

// What the first byte chooses. Extensions alone first, then formats that are said.
constexpr std::array<Extension, 28> Extensions{ { { ".spheres", vtkSpherePackingReader::AUTO },
  { ".txt", vtkSpherePackingReader::AUTO }, { ".csv", vtkSpherePackingReader::AUTO },
  { ".dump", vtkSpherePackingReader::AUTO }, { ".pqr", vtkSpherePackingReader::AUTO },
  { ".sph", vtkSpherePackingReader::AUTO }, { ".xyz", vtkSpherePackingReader::AUTO },
  { ".xyzr", vtkSpherePackingReader::AUTO }, { ".data", vtkSpherePackingReader::AUTO },
  { ".dat", vtkSpherePackingReader::AUTO }, { ".xyzd", vtkSpherePackingReader::XYZD },
  { ".swc", vtkSpherePackingReader::AUTO }, { ".geo", vtkSpherePackingReader::AUTO },
  { ".ma", vtkSpherePackingReader::AUTO }, { ".mdpa", vtkSpherePackingReader::AUTO },
  { ".spheres", vtkSpherePackingReader::SPHERES }, { ".txt", vtkSpherePackingReader::YADE },
  { ".txt", vtkSpherePackingReader::MERCURY }, { ".txt", vtkSpherePackingReader::LAMMPS_DATA },
  { ".sph", vtkSpherePackingReader::DOCK }, { ".sph", vtkSpherePackingReader::HOLE },
  { ".txt", vtkSpherePackingReader::SWC }, { ".txt", vtkSpherePackingReader::GENGEO },
  { ".txt", vtkSpherePackingReader::MEDIAL_AXIS }, { ".txt", vtkSpherePackingReader::KRATOS },
  { ".txt", vtkSpherePackingReader::PACKLSD }, { ".txt", vtkSpherePackingReader::ESYS },
  { ".sph", vtkSpherePackingReader::SPHERE_TREE } } };

[[noreturn]] void Fail(const std::string& what)
{
  std::cerr << "FAULT: " << what << std::endl;
  std::abort();
}

// Takes errors in place of VTK's output window.
class ErrorCounter : public vtkCommand
{
public:
  static ErrorCounter* New() { return new ErrorCounter; }
  void Execute(vtkObject*, unsigned long, void*) override { ++this->Count; }
  int Count = 0;
};

struct Result
{
  std::string Message;
  vtkNew<vtkPolyData> Packing;
};

void Read(vtkSpherePackingReader* reader, ErrorCounter* errors, Result& result)
{
  errors->Count = 0;
  reader->Modified();
  reader->Update();
  result.Message = reader->GetErrorMessage();
  result.Packing->ShallowCopy(reader->GetOutput());
  vtkPolyData* const packing = result.Packing;
  if (errors->Count != (result.Message.empty() ? 0 : 1))
  {
    Fail(std::to_string(errors->Count) + " errors, message: " + result.Message);
  }
  if (!result.Message.empty())
  {
    const bool nothing =
      packing->GetNumberOfPoints() == 0 && packing->GetPointData()->GetNumberOfArrays() == 0;
    if (!nothing || result.Message.size() > 4000)
    {
      Fail("half a packing or a long message beside: " + result.Message.substr(0, 4000));
    }
    return;
  }
  const vtkIdType count = packing->GetNumberOfPoints();
  for (int i = 0; i < packing->GetPointData()->GetNumberOfArrays(); ++i)
  {
    if (packing->GetPointData()->GetAbstractArray(i)->GetNumberOfTuples() != count)
    {
      Fail("an array of another length than the points");
    }
  }
  if (vtkDataArray* const radii = packing->GetPointData()->GetArray("radius"))
  {
    for (vtkIdType i = 0; i < count; ++i)
    {
      const double r = radii->GetTuple1(i);
      if (!(r >= 0.0) || std::isinf(r))
      {
        Fail("a radius that is none");
      }
    }
  }
}

void CheckSame(const Result& a, const Result& b, const char* what)
{
  if (a.Message != b.Message)
  {
    Fail(std::string(what) + ": " + a.Message + " / " + b.Message);
  }
  vtkPointData* const left = a.Packing->GetPointData();
  vtkPointData* const right = b.Packing->GetPointData();
  bool same = a.Packing->GetNumberOfPoints() == b.Packing->GetNumberOfPoints() &&
    left->GetNumberOfArrays() == right->GetNumberOfArrays();
  for (int i = 0; same && i < left->GetNumberOfArrays(); ++i)
  {
    vtkAbstractArray* const array = left->GetAbstractArray(i);
    vtkAbstractArray* const other = right->GetAbstractArray(i);
    const std::string name = array->GetName() ? array->GetName() : "";
    same = name == (other->GetName() ? other->GetName() : "");
    for (vtkIdType k = 0; same && k < array->GetNumberOfValues(); ++k)
    {
      same = array->GetVariantValue(k).ToString() == other->GetVariantValue(k).ToString();
    }
  }
  if (!same)
  {
    Fail(std::string(what) + " changes the packing");
  }
}

void CheckSteps(vtkSpherePackingReader* reader, ErrorCounter* errors)
{
  using SDDP = vtkStreamingDemandDrivenPipeline;
  vtkInformation* const information = reader->GetOutputInformation(0);
  const int count = information->Length(SDDP::TIME_STEPS());
  for (const int i : { 0, count / 2, count - 1 })
  {
    if (i >= 0 && i < count)
    {
      errors->Count = 0;
      reader->UpdateTimeStep(information->Get(SDDP::TIME_STEPS())[i]);
    }
  }
}
}

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size)
{
  if (size < 2)
  {
    return -1;
  }
  const Extension& extension = Extensions[data[0] % Extensions.size()];
  const std::string path = ScratchPath(extension.Text);
  WriteScratch(path, data + 2, size - 2);
  vtkNew<vtkSpherePackingReader> reader;
  vtkNew<ErrorCounter> errors;
  reader->AddObserver(vtkCommand::ErrorEvent, errors);
  reader->SetFileName(path.c_str());
  reader->SetFormat(extension.Format);
  reader->SetRadiusOptional((data[1] & 1) != 0);
  if ((data[1] & 6) == 6)
  {
    reader->SetColumns((data[1] & 8) != 0 ? "x y z r" : "id x y z d");
  }
  Result whole;
  Read(reader, errors, whole);
  if (whole.Message.empty())
  {
    CheckSteps(reader, errors);
  }
  if ((data[1] & 0x30) == 0)
  {
    reader->SetChunkSize(1 + data[1] / 64 * 13);
    Result chunks;
    Read(reader, errors, chunks);
    CheckSame(whole, chunks, "another size of chunks");
  }
  if ((data[1] & 0x30) == 0x10)
  {
    reader->SetOutputPointsPrecision(vtkSpherePackingReader::SINGLE_PRECISION);
    Result single;
    Read(reader, errors, single);
    // What is too large for a float may be an error of its own.
    if (single.Message.empty() && !whole.Message.empty())
    {
      Fail("single precision passes: " + whole.Message);
    }
  }
  return 0;
}
