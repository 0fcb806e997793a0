// SPDX-License-Identifier: BSD-3-Clause
#ifndef AtomicFile_h
#define AtomicFile_h

#include "io/PartFile.h"

#include <cstddef>
#include <optional>
#include <string>

namespace spherepacking
{
/**
 * Replaces a file atomically: writes one without a name in the same folder, which takes the name
 * when it is complete, so that an earlier file stays as it was whatever goes wrong. Without
 * Commit() nothing is left of it.
 *
 * Symbolic links are followed, and other hard links to an earlier file keep what that held. A file
 * that replaces one has its permissions and its group, and while it is written nobody but its
 * owner may open it; a new one has those that any new file has in that folder.
 *
 * files/replace.py does the same for pictures and others.
 */
class AtomicFile
{
public:
  /// Throws a PackingFileError unless a file may be written there.
  explicit AtomicFile(const std::string& file);

  void Write(const char* bytes, std::size_t length);

  /// Puts the file in its place, once all of it is on the disk.
  void Commit();

private:
  [[noreturn]] void ThrowFull();

  std::string File;   // as the user names it, for messages
  std::string Target; // with links followed
  std::optional<PartFile> Part;
};
}

#endif
