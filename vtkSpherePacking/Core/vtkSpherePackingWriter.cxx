// SPDX-License-Identifier: BSD-3-Clause
#include "vtkSpherePackingWriter.h"

#include "bridge/Guard.h"
#include "bridge/SetText.h"
#include "io/PackingFileError.h"
#include "io/Progress.h"
#include "io/WritePacking.h"

#include "vtkErrorCode.h"
#include "vtkInformation.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkPolyData.h"
#include "vtkSpherePackingInput.h"
#include "vtksys/SystemTools.hxx"

#include <new>

using namespace spherepacking;

vtkStandardNewMacro(vtkSpherePackingWriter);

namespace
{
// The format by the extension, where those that several formats have stand for one of them.
Format WrittenFormat(const std::string& file)
{
  using vtksys::SystemTools;
  const std::string extension = SystemTools::LowerCase(SystemTools::GetFilenameLastExtension(file));
  const bool isXyz = extension == ".xyz" || extension == ".extxyz" || extension == ".exyz";
  return extension == ".txt" ? Format::Yade : isXyz ? Format::Xyz : FormatOfExtension(file);
}

// What is asked for, or by the extension of the file, which there must be.
Format FormatOf(const char* file, int format)
{
  if (!file || !*file)
  {
    throw PackingFileError(
      vtkErrorCode::NoFileNameError, "FileName: found none, expected the name of a file to write");
  }
  const auto kind = static_cast<Format>(format);
  return kind == Format::Auto ? WrittenFormat(file) : kind;
}
}

//------------------------------------------------------------------------------
vtkSpherePackingWriter::vtkSpherePackingWriter()
{
  this->SetRadiusArrayName("radius");
  this->SetNumberOfOutputPorts(0);
}

//------------------------------------------------------------------------------
vtkSpherePackingWriter::~vtkSpherePackingWriter()
{
  this->SetFileName(nullptr);
  this->SetRadiusArrayName(nullptr);
}

//------------------------------------------------------------------------------
void vtkSpherePackingWriter::SetFileName(const char* text)
{
  if (SetText(this->FileName, text, this->FileNameLost))
  {
    this->Modified();
  }
}

//------------------------------------------------------------------------------
void vtkSpherePackingWriter::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "FileName: " << (this->FileName ? this->FileName : "(none)") << "\n";
  os << indent << "Format: " << this->Format << "\n";
  os << indent << "RadiusArrayName: " << (this->RadiusArrayName ? this->RadiusArrayName : "(none)")
     << "\n";
  os << indent << "SortByRadius: " << (this->SortByRadius ? "On" : "Off") << "\n";
  os << indent << "ErrorMessage: " << this->ErrorMessage << "\n";
}

//------------------------------------------------------------------------------
int vtkSpherePackingWriter::Write()
{
  // Without this a second Write() of an unchanged packing would do nothing.
  this->Modified();
  this->Written = false;
  this->ErrorMessage.clear();
  this->SetErrorCode(vtkErrorCode::NoError);
  if (this->GetNumberOfInputConnections(0) == 0)
  {
    const auto work = []
    {
      throw CodedError(vtkErrorCode::UnknownError, "the writer has no input, expected a packing");
    };
    RunGuarded(this, this->ErrorMessage, [] { return std::string(); }, work);
    return 0;
  }
  this->Update();
  return this->Written ? 1 : 0;
}

//------------------------------------------------------------------------------
int vtkSpherePackingWriter::RequestData(
  vtkInformation*, vtkInformationVector** inputVector, vtkInformationVector*)
{
  const auto work = [&] { this->WriteFile(vtkPolyData::GetData(inputVector[0])); };
  const auto outOfMemory = [this]
  {
    return std::string(this->FileName ? this->FileName : "FileName") +
      ": not enough memory to write it";
  };
  this->Written = RunGuarded(this, this->ErrorMessage, outOfMemory, work) == Outcome::Done;
  // 1 even after an error, since the executive would otherwise report another one.
  return 1;
}

//------------------------------------------------------------------------------
int vtkSpherePackingWriter::CheckFile()
{
  this->ErrorMessage.clear();
  this->SetErrorCode(vtkErrorCode::NoError);
  const auto work = [&]
  {
    if (this->FileNameLost)
    {
      throw std::bad_alloc();
    }
    const spherepacking::Format kind = FormatOf(this->FileName, this->Format);
    CheckWritable(this->FileName, kind);
  };
  const auto outOfMemory = [] { return std::string("not enough memory"); };
  return RunGuarded(this, this->ErrorMessage, outOfMemory, work) == Outcome::Done ? 1 : 0;
}

//------------------------------------------------------------------------------
void vtkSpherePackingWriter::WriteFile(vtkPolyData* packing)
{
  if (this->FileNameLost)
  {
    throw std::bad_alloc();
  }
  WriteOptions options;
  options.Kind = FormatOf(this->FileName, this->Format);
  const std::string file = this->FileName;
  options.Packing = packing;
  options.SortByRadius = this->SortByRadius;
  vtkNew<vtkSpherePackingInput> input;
  options.Radii = input->FindRadii(packing, this->RadiusArrayName);
  if (!options.Radii)
  {
    const std::string message = input->GetMessage();
    throw PackingFileError(vtkErrorCode::UnknownError,
      file + ": " +
        (message.empty() ? "the packing holds no sphere, expected at least one" : message));
  }
  spherepacking::Progress progress(this);
  WritePacking(file, options, progress);
}
