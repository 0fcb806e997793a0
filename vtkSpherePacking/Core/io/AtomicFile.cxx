// SPDX-License-Identifier: BSD-3-Clause
#include "io/AtomicFile.h"

#include "io/PackingFileError.h"

#include "vtkErrorCode.h"
#include "vtksys/SystemTools.hxx"

#include <cerrno>
#include <cstring>
#include <filesystem>
#include <system_error>

namespace spherepacking
{
using vtksys::SystemTools;

//------------------------------------------------------------------------------
AtomicFile::AtomicFile(const std::string& file)
  : File(file)
  , Target(SystemTools::PathExists(file) ? SystemTools::GetRealPath(file) : file)
{
  if (SystemTools::FileIsDirectory(this->Target))
  {
    throw PackingFileError(
      vtkErrorCode::CannotOpenFileError, file + ": found a directory, expected a file to write");
  }
  // A device or a pipe would be replaced by the rename.
  if (SystemTools::PathExists(this->Target) &&
    !std::filesystem::is_regular_file(std::filesystem::u8path(this->Target)))
  {
    throw PackingFileError(vtkErrorCode::CannotOpenFileError,
      file + ": found something that is no regular file, expected one or none");
  }
  // The rename would not ask for it.
  if (SystemTools::PathExists(this->Target) &&
    !SystemTools::TestFileAccess(this->Target, vtksys::TEST_FILE_WRITE))
  {
    throw PackingFileError(vtkErrorCode::CannotOpenFileError,
      file + ": found a file that is write-protected, expected one that can be written to");
  }
  // "x" fails rather than overwrite what somebody else has there.
  for (int attempt = 0; !this->Stream && attempt < 100; ++attempt)
  {
    this->Temporary = this->Target + ".part" + std::to_string(attempt);
    errno = 0;
    this->Stream = SystemTools::Fopen(this->Temporary, "wbx");
    if (!this->Stream && errno != EEXIST)
    {
      break;
    }
  }
  if (!this->Stream)
  {
    throw PackingFileError(vtkErrorCode::CannotOpenFileError,
      file + ": cannot write '" + this->Temporary + "' (" + std::strerror(errno) +
        "), expected a folder that can be written to");
  }
}

//------------------------------------------------------------------------------
AtomicFile::~AtomicFile()
{
  if (this->Stream)
  {
    std::fclose(this->Stream);
    SystemTools::RemoveFile(this->Temporary);
  }
}

//------------------------------------------------------------------------------
void AtomicFile::Write(const char* bytes, std::size_t length)
{
  if (std::fwrite(bytes, 1, length, this->Stream) != length)
  {
    this->ThrowFull();
  }
}

//------------------------------------------------------------------------------
void AtomicFile::Commit()
{
  if (std::fflush(this->Stream) != 0)
  {
    this->ThrowFull();
  }
  mode_t permissions = 0;
  if (SystemTools::GetPermissions(this->Target, permissions))
  {
    SystemTools::SetPermissions(this->Temporary, permissions);
  }
  const int closed = std::fclose(this->Stream);
  this->Stream = nullptr;
  std::error_code error(closed == 0 ? 0 : errno, std::generic_category());
  if (!error)
  {
    std::filesystem::rename(
      std::filesystem::u8path(this->Temporary), std::filesystem::u8path(this->Target), error);
  }
  if (error)
  {
    SystemTools::RemoveFile(this->Temporary);
    throw PackingFileError(vtkErrorCode::CannotOpenFileError,
      this->File + ": the file could not be put in its place (" + error.message() +
        "), expected one that can be replaced");
  }
}

//------------------------------------------------------------------------------
void AtomicFile::ThrowFull()
{
  throw PackingFileError(vtkErrorCode::OutOfDiskSpaceError,
    this->File + ": writing stopped (" + std::strerror(errno) + "), expected room for the packing");
}
}
