// SPDX-License-Identifier: BSD-3-Clause
#include "io/FileBytes.h"

#include "base/HugePages.h"
#include "io/PackingFileError.h"
#include "io/Progress.h"

#include "vtkErrorCode.h"
#include "vtksys/FStream.hxx"
#include "vtksys/SystemTools.hxx"

#include <algorithm>
#include <atomic>
#include <cerrno>
#include <cstring>
#include <filesystem>
#include <system_error>

namespace spherepacking
{
namespace
{
bool ReadBlock(const std::string& path, unsigned long long offset, char* to, std::streamsize length)
{
  vtksys::ifstream stream(path.c_str(), std::ios::in | std::ios::binary);
  stream.seekg(static_cast<std::streamoff>(offset));
  return stream && stream.read(to, length);
}
}

//------------------------------------------------------------------------------
FileBytes::FileBytes(unsigned long long length)
  : Bytes(new char[length + 1])
  , Length(length)
{
  AdviseHugePages(this->Bytes.get(), length);
  this->Bytes[length] = '\n';
}

//------------------------------------------------------------------------------
unsigned long long FileBytes::Size(const std::string& path)
{
  using vtksys::SystemTools;
  if (!SystemTools::PathExists(path))
  {
    throw PackingFileError(
      vtkErrorCode::FileNotFoundError, path + ": found no such file, expected a sphere packing");
  }
  if (SystemTools::FileIsDirectory(path))
  {
    throw PackingFileError(
      vtkErrorCode::CannotOpenFileError, path + ": found a directory, expected a file");
  }
  // Opening a pipe would wait for somebody to write into it. What has no type, such as a link to
  // itself, cannot be opened, and that says why.
  std::error_code error;
  if (!std::filesystem::is_regular_file(std::filesystem::u8path(path), error) && !error)
  {
    throw PackingFileError(vtkErrorCode::CannotOpenFileError,
      path + ": found a pipe or a device, expected a regular file");
  }
  errno = 0;
  const vtksys::ifstream stream(path.c_str(), std::ios::in | std::ios::binary);
  if (!stream)
  {
    throw PackingFileError(vtkErrorCode::CannotOpenFileError,
      path + ": cannot open the file (" + std::strerror(errno) + "), expected a readable one");
  }
  const unsigned long long size = SystemTools::FileLength(path);
  if (size == 0)
  {
    throw PackingFileError(
      vtkErrorCode::PrematureEndOfFileError, path + ": the file is empty, expected spheres");
  }
  return size;
}

//------------------------------------------------------------------------------
FileBytes FileBytes::Read(const std::string& path, Progress& progress)
{
  return FileBytes::ReadRange(path, 0, FileBytes::Size(path), progress);
}

//------------------------------------------------------------------------------
FileBytes FileBytes::ReadRange(
  const std::string& path, unsigned long long offset, unsigned long long length, Progress& progress)
{
  // In parallel since the time goes into page faults, at the first touch of the memory.
  constexpr unsigned long long block = 1 << 20;
  FileBytes bytes(length);
  std::atomic<bool> complete{ true };
  const auto readBlocks = [&](vtkIdType first, vtkIdType last)
  {
    const unsigned long long from = first * block;
    const auto count = static_cast<std::streamsize>(std::min(length, last * block) - from);
    if (!ReadBlock(path, offset + from, bytes.Bytes.get() + from, count))
    {
      complete = false;
    }
  };
  const auto throwIfIncomplete = [&]
  {
    if (!complete)
    {
      throw PackingFileError(vtkErrorCode::PrematureEndOfFileError,
        path + ": the file could not be read to its end, expected " +
          std::to_string(offset + length) + " bytes");
    }
  };
  ForInBatches(static_cast<vtkIdType>((length + block - 1) / block), 1, progress, readBlocks,
    throwIfIncomplete);
  return bytes;
}

//------------------------------------------------------------------------------
FileBytes FileBytes::ReadHead(const std::string& path, unsigned long long length)
{
  FileBytes bytes(std::min(FileBytes::Size(path), length));
  if (!ReadBlock(path, 0, bytes.Bytes.get(), static_cast<std::streamsize>(bytes.Length)))
  {
    throw PackingFileError(vtkErrorCode::CannotOpenFileError,
      path + ": cannot read the file, expected " + std::to_string(bytes.Length) + " bytes");
  }
  return bytes;
}

//------------------------------------------------------------------------------
FileBytes FileBytes::Copy(std::string_view text)
{
  FileBytes bytes(text.size());
  std::copy(text.begin(), text.end(), bytes.Bytes.get());
  return bytes;
}

//------------------------------------------------------------------------------
FileRanges::FileRanges(const std::string& path)
  : Path(path)
  , Stream(path.c_str(), std::ios::in | std::ios::binary)
{
}

//------------------------------------------------------------------------------
void FileRanges::Read(unsigned long long offset, char* to, std::size_t length)
{
  this->Stream.seekg(static_cast<std::streamoff>(offset));
  if (!this->Stream || !this->Stream.read(to, static_cast<std::streamsize>(length)))
  {
    throw PackingFileError(vtkErrorCode::PrematureEndOfFileError,
      this->Path + ": the file could not be read to its end, expected " +
        std::to_string(offset + length) + " bytes");
  }
}
}
