// SPDX-License-Identifier: BSD-3-Clause
#include "vtkSpherePackingReader.h"

#include "bridge/Guard.h"
#include "io/PackingFileError.h"
#include "io/PackingFormats.h"
#include "io/Progress.h"
#include "io/TimeStepCache.h"

#include "vtkDataObject.h"
#include "vtkDoubleArray.h"
#include "vtkErrorCode.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkMath.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkPolyData.h"
#include "vtkStreamingDemandDrivenPipeline.h"

#include <cstddef>
#include <optional>
#include <vector>

using namespace spherepacking;

static_assert(vtkSpherePackingReader::AUTO == static_cast<int>(Format::Auto) &&
    vtkSpherePackingReader::XYZD == static_cast<int>(Format::Xyzd) &&
    vtkSpherePackingReader::SPHERE_TREE == static_cast<int>(Format::SphereTree) &&
    vtkSpherePackingReader::ESYS == static_cast<int>(Format::EsysSnapshot),
  "Format and FileFormats must have the same values");

namespace
{
// Whether the names of columns may be given: not where the format says what they are.
bool TakesColumns(Format format)
{
  switch (format)
  {
    case Format::Spheres:
    case Format::Xyzr:
    case Format::Yade:
    case Format::Csv:
    case Format::LammpsData:
    case Format::Xyz:
      return true;
    default:
      return false;
  }
}
}

namespace
{
// Reads a file of a format without time steps.
PackingArrays ReadWhole(spherepacking::Format format, const std::string& file,
  const ReadOptions& options, spherepacking::Progress& progress)
{
  switch (format)
  {
    case Format::Xyzd:
      return ReadXyzd(file, options, progress);
    case Format::Pqr:
      return ReadPqr(file, options, progress);
    case Format::SphereTree:
      return ReadSphereTree(file, options, progress);
    case Format::Dock:
      return ReadDock(file, options, progress);
    case Format::Hole:
      return ReadHole(file, options, progress);
    case Format::Swc:
      return ReadSwc(file, options, progress);
    case Format::GenGeo:
      return ReadGenGeo(file, options, progress);
    case Format::MedialAxis:
      return ReadMedialAxis(file, options, progress);
    case Format::Kratos:
      return ReadKratos(file, options, progress);
    case Format::PackLsd:
      return ReadPackLsd(file, options, progress);
    case Format::EsysSnapshot:
      return ReadEsysSnapshot(file, options, progress);
    case Format::LammpsData:
      return ReadLammpsData(file, options, progress);
    default:
      return ReadTextTable(file, format, options, progress);
  }
}
}

class vtkSpherePackingReader::Internals
{
public:
  TimeStepCache Steps;
  vtkNew<vtkDoubleArray> StepTimes;
  int Announced = 0; // after how many searches the time steps of the output were set
};

vtkStandardNewMacro(vtkSpherePackingReader);

//------------------------------------------------------------------------------
vtkSpherePackingReader::vtkSpherePackingReader()
  : Internal(new Internals)
{
  this->SetNumberOfInputPorts(0);
}

//------------------------------------------------------------------------------
vtkSpherePackingReader::~vtkSpherePackingReader()
{
  this->SetFileName(nullptr);
  this->SetColumns(nullptr);
}

//------------------------------------------------------------------------------
void vtkSpherePackingReader::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "FileName: " << (this->FileName ? this->FileName : "(none)") << "\n";
  os << indent << "Format: " << this->Format << "\n";
  os << indent << "OutputPointsPrecision: " << this->OutputPointsPrecision << "\n";
  os << indent << "ChunkSize: " << this->ChunkSize << "\n";
  os << indent << "Columns: " << (this->Columns ? this->Columns : "(none)") << "\n";
  os << indent << "RadiusOptional: " << this->RadiusOptional << "\n";
  os << indent << "ErrorMessage: " << this->ErrorMessage << "\n";
  os << indent << "RadiusName: " << this->RadiusName << "\n";
}

//------------------------------------------------------------------------------
int vtkSpherePackingReader::RequestInformation(
  vtkInformation*, vtkInformationVector**, vtkInformationVector* outputVector)
{
  using SDDP = vtkStreamingDemandDrivenPipeline;
  vtkInformation* outInfo = outputVector->GetInformationObject(0);
  Internals& internal = *this->Internal;
  const auto forget = [&]
  {
    outInfo->Remove(SDDP::TIME_STEPS());
    outInfo->Remove(SDDP::TIME_RANGE());
    internal.StepTimes->Initialize();
    internal.StepTimes->Modified();
  };
  if (!this->FileName)
  {
    forget();
    return 1;
  }
  const auto work = [&]
  {
    auto format = static_cast<spherepacking::Format>(this->Format);
    format = format == Format::Auto ? GuessFormat(this->FileName) : format;
    if (!HasSteps(format))
    {
      forget();
      return;
    }
    spherepacking::Progress progress(this);
    const TimeSteps& steps = internal.Steps.Find(format, this->FileName, progress);
    // A loop over all steps asks at each of them.
    if (outInfo->Has(SDDP::TIME_STEPS()) && internal.Announced == internal.Steps.Searches())
    {
      return;
    }
    forget();
    for (const TimeStep& step : steps.Steps)
    {
      internal.StepTimes->InsertNextValue(step.Time.value_or(vtkMath::Nan()));
    }
    internal.Announced = internal.Steps.Searches();
    const std::vector<double>& times = steps.Values;
    const double range[2] = { times.front(), times.back() };
    outInfo->Set(SDDP::TIME_STEPS(), times.data(), static_cast<int>(times.size()));
    outInfo->Set(SDDP::TIME_RANGE(), range, 2);
  };
  // RequestData() meets the same error.
  if (RunGuarded(this, this->ErrorMessage, this->OutOfMemory(), work, Report::Later) !=
    Outcome::Done)
  {
    forget();
  }
  return 1;
}

//------------------------------------------------------------------------------
vtkDoubleArray* vtkSpherePackingReader::GetStepTimes() const
{
  return this->Internal->StepTimes;
}

//------------------------------------------------------------------------------
std::string vtkSpherePackingReader::OutOfMemory() const
{
  return std::string(this->FileName ? this->FileName : "FileName") +
    ": not enough memory for the file and its spheres";
}

//------------------------------------------------------------------------------
int vtkSpherePackingReader::RequestData(
  vtkInformation*, vtkInformationVector**, vtkInformationVector* outputVector)
{
  vtkInformation* outInfo = outputVector->GetInformationObject(0);
  vtkPolyData* output = vtkPolyData::GetData(outInfo);
  const auto work = [&] { this->ReadFile(outInfo, output); };
  if (RunGuarded(this, this->ErrorMessage, this->OutOfMemory(), work) == Outcome::Done)
  {
    return 1;
  }
  output->Initialize();
  // Makes the next update try again. A return of 0 would do that, too, but the executive would then
  // report an uninformative error of its own.
  outInfo->Set(vtkDemandDrivenPipeline::DATA_NOT_GENERATED(), 1);
  return 1;
}

//------------------------------------------------------------------------------
void vtkSpherePackingReader::ReadFile(vtkInformation* outInfo, vtkPolyData* output)
{
  this->RadiusName.clear();
  if (!this->FileName || !*this->FileName)
  {
    throw PackingFileError(
      vtkErrorCode::NoFileNameError, "FileName: found none, expected the name of a packing file");
  }
  const std::string file = this->FileName;
  const ReadOptions options{ this->OutputPointsPrecision == SINGLE_PRECISION, this->ChunkSize,
    this->Columns ? this->Columns : "", this->RadiusOptional };
  spherepacking::Progress progress(this);
  auto format = static_cast<spherepacking::Format>(this->Format);
  if (format == Format::Auto)
  {
    format = GuessFormat(file);
  }
  if (!options.Columns.empty() && !TakesColumns(format))
  {
    throw PackingFileError(vtkErrorCode::FileFormatError,
      file + ": found names of columns for a format that says what its columns are, expected none");
  }
  if (HasSteps(format))
  {
    this->ReadStep(format, file, options, progress, outInfo, output);
  }
  else
  {
    this->TakeArrays(ReadWhole(format, file, options, progress), output);
  }
}

//------------------------------------------------------------------------------
void vtkSpherePackingReader::TakeArrays(PackingArrays arrays, vtkPolyData* output)
{
  this->RadiusName = arrays.GetRadiusName();
  arrays.MoveTo(output);
}

//------------------------------------------------------------------------------
void vtkSpherePackingReader::ReadStep(spherepacking::Format format, const std::string& file,
  const ReadOptions& options, spherepacking::Progress& progress, vtkInformation* outInfo,
  vtkPolyData* output)
{
  using SDDP = vtkStreamingDemandDrivenPipeline;
  std::optional<double> value;
  if (outInfo->Has(SDDP::UPDATE_TIME_STEP()))
  {
    value = outInfo->Get(SDDP::UPDATE_TIME_STEP());
  }
  const TimeSteps& steps = this->Internal->Steps.Find(format, file, progress);
  const std::size_t chosen = steps.IndexOf(value);
  const auto read = format == Format::Dump ? ReadDump
    : format == Format::Xyz                ? ReadXyz
                                           : ReadMercury;
  this->TakeArrays(read(file, steps.Steps[chosen], options, progress), output);
  output->GetInformation()->Set(vtkDataObject::DATA_TIME_STEP(), steps.Values[chosen]);
}
