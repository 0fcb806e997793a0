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
  if (!this->Part.emplace(this->Target).Stream())
  {
    throw PackingFileError(vtkErrorCode::CannotOpenFileError,
      file + ": cannot write beside it (" + std::strerror(errno) +
        "), expected a folder that can be written to");
  }
}

//------------------------------------------------------------------------------
void AtomicFile::Write(const char* bytes, std::size_t length)
{
  if (std::fwrite(bytes, 1, length, this->Part->Stream()) != length)
  {
    this->ThrowFull();
  }
}

//------------------------------------------------------------------------------
void AtomicFile::Commit()
{
  if (this->Part->TakeName(this->Target))
  {
    return;
  }
  if (errno == ENOSPC || errno == EDQUOT || errno == EFBIG || errno == EIO)
  {
    this->ThrowFull();
  }
  throw PackingFileError(vtkErrorCode::CannotOpenFileError,
    this->File + ": the file could not be put in its place (" + std::strerror(errno) +
      "), expected one that can be replaced");
}

//------------------------------------------------------------------------------
void AtomicFile::ThrowFull()
{
  throw PackingFileError(vtkErrorCode::OutOfDiskSpaceError,
    this->File + ": writing stopped (" + std::strerror(errno) + "), expected room for the packing");
}
}
