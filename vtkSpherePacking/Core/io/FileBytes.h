// SPDX-License-Identifier: BSD-3-Clause
#ifndef FileBytes_h
#define FileBytes_h

#include "vtksys/FStream.hxx"

#include <cstddef>
#include <memory>
#include <string>
#include <string_view>

namespace spherepacking
{
class Progress;

/**
 * A file, or a range of it, in memory. It is read rather than mapped, because a mapped file that
 * another process truncates kills the reader with SIGBUS.
 */
class FileBytes
{
public:
  /// The size of `path`. Throws unless that is a regular file that can be opened and is not empty.
  static unsigned long long Size(const std::string& path);

  /// Reads all of `path`, in parallel.
  static FileBytes Read(const std::string& path, Progress& progress);

  /// Reads `length` bytes of `path` from `offset` on, in parallel.
  static FileBytes ReadRange(const std::string& path, unsigned long long offset,
    unsigned long long length, Progress& progress);

  /// Reads the first `length` bytes of `path`, or all if there are fewer.
  static FileBytes ReadHead(const std::string& path, unsigned long long length);

  /// `text`, as if it were that of a file.
  static FileBytes Copy(std::string_view text);

  const char* Begin() const { return this->Bytes.get(); }

  /// The end of the bytes. `*End()` may be read and is a line feed, a sentinel, so that a scan for
  /// line ends needs no bounds check.
  const char* End() const { return this->Bytes.get() + this->Length; }

private:
  explicit FileBytes(unsigned long long length);

  std::unique_ptr<char[]> Bytes;
  unsigned long long Length;
};

/// Ranges of a file that stays open.
class FileRanges
{
public:
  explicit FileRanges(const std::string& path);

  /// Reads `length` bytes from `offset` on to `to`, or throws.
  void Read(unsigned long long offset, char* to, std::size_t length);

private:
  std::string Path;
  vtksys::ifstream Stream;
};
}

#endif
