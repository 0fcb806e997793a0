// SPDX-License-Identifier: BSD-3-Clause
#ifndef AtomicFile_h
#define AtomicFile_h

#include <cstdio>
#include <string>

namespace spherepacking
{
/**
 * A file that appears under its name only when it is complete: it is written beside its place
 * under another name and renamed in the end, so whatever goes wrong leaves an earlier file as it
 * was. Without Commit() the destructor removes what was written.
 */
class AtomicFile
{
public:
  explicit AtomicFile(const std::string& file);
  ~AtomicFile();
  AtomicFile(const AtomicFile&) = delete;
  AtomicFile& operator=(const AtomicFile&) = delete;

  void Write(const char* bytes, std::size_t length);

  /// Puts the file in its place.
  void Commit();

private:
  [[noreturn]] void ThrowFull();

  std::string File;   // as the user names it, for messages
  std::string Target; // where it goes, links followed
  std::string Temporary;
  std::FILE* Stream = nullptr;
};
}

#endif
