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

namespace
{
namespace fs = std::filesystem;

// The path of a file with links followed, even if the last one leads to none.
fs::path Follow(const std::string& file)
{
  constexpr int maximumLinks = 40; // as many as Linux follows
  fs::path path = fs::u8path(file);
  std::error_code error;
  for (int link = 0; fs::is_symlink(path, error); ++link)
  {
    if (link == maximumLinks)
    {
      throw PackingFileError(vtkErrorCode::CannotOpenFileError,
        file + ": found links that lead in a circle, expected a file or none");
    }
    path = path.parent_path() / fs::read_symlink(path, error);
  }
  return path;
}
}

//------------------------------------------------------------------------------
AtomicFile::AtomicFile(const std::string& file)
  : File(file)
  , Target(Follow(file).u8string())
{
  if (SystemTools::FileIsDirectory(this->Target))
  {
    throw PackingFileError(
      vtkErrorCode::CannotOpenFileError, file + ": found a directory, expected a file to write");
  }
  // A device or a pipe would be replaced by the rename.
  std::error_code error;
  const fs::path target = fs::u8path(this->Target);
  if (fs::exists(target, error) && !fs::is_regular_file(target, error))
  {
    throw PackingFileError(vtkErrorCode::CannotOpenFileError,
      file + ": found something that is no regular file, expected one or none");
  }
  // A rename does not ask for this permission.
  if (SystemTools::PathExists(this->Target) &&
    !SystemTools::TestFileAccess(this->Target, vtksys::TEST_FILE_WRITE))
  {
    throw PackingFileError(vtkErrorCode::CannotOpenFileError,
      file + ": found a file that is write-protected, expected one that can be written to");
  }
  // "x" fails rather than overwrite a file of somebody else. The name does not contain the
  // target's, since a longer one than that may be too long.
  for (int attempt = 0; !this->Stream && attempt < 100; ++attempt)
  {
    this->Temporary =
      (target.parent_path() / (".spherepacking" + std::to_string(attempt) + ".part")).u8string();
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
