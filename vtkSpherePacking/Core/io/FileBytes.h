// SPDX-License-Identifier: BSD-3-Clause
#ifndef FileBytes_h
#define FileBytes_h

#include <memory>
#include <string>

namespace spherepacking
{
class Progress;

/**
 * A file, or a range of it, in memory. It is read rather than mapped, because a mapped file that
 * another process cuts short kills the reader with SIGBUS.
 */
class FileBytes
{
public:
  /// The size of `path`, which must be a regular file with something in it.
  static unsigned long long Size(const std::string& path);

  /// All of `path`, read by all threads.
  static FileBytes Read(const std::string& path, Progress& progress);

  /// `length` bytes of `path` from `offset` on.
  static FileBytes ReadRange(const std::string& path, unsigned long long offset,
    unsigned long long length, Progress& progress);

  /// At most `length` bytes from the beginning.
  static FileBytes ReadHead(const std::string& path, unsigned long long length);

  const char* Begin() const { return this->Bytes.get(); }

  /// One beyond the last byte. `*End()` may be read and is a line feed, so that a scan of text
  /// needs no other check for the end.
  const char* End() const { return this->Bytes.get() + this->Length; }

private:
  explicit FileBytes(unsigned long long length);

  std::unique_ptr<char[]> Bytes;
  unsigned long long Length;
};
}

#endif
