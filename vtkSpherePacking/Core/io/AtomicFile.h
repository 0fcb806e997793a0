// SPDX-License-Identifier: BSD-3-Clause
#ifndef AtomicFile_h
#define AtomicFile_h

#include <cstdio>
#include <string>

namespace spherepacking
{
/**
 * Replaces a file atomically: writes a temporary file in the same folder and renames it at the end,
 * so that an earlier file stays as it was whatever goes wrong. Without Commit() the destructor
 * removes the temporary file.
 */
class AtomicFile
{
public:
  explicit AtomicFile(const std::string& file);
  ~AtomicFile();
  AtomicFile(const AtomicFile&) = delete;
  AtomicFile& operator=(const AtomicFile&) = delete;

  void Write(const char* bytes, std::size_t length);

  /// Renames the temporary file to the final name.
  void Commit();

private:
  [[noreturn]] void ThrowFull();

  std::string File;   // as the user names it, for messages
  std::string Target; // with links followed
  std::string Temporary;
  std::FILE* Stream = nullptr;
};
}

#endif
